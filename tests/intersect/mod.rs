//! Intersections of curves, compared with a slow reference that discards only what is certain, and with known cases.

mod adversarial;
mod covering;
mod generate;
mod known;
mod metamorphic;
mod random;
mod reference;
mod reported;
mod selves;
mod splines;
