//! Arc length, equidistant parameters, area, moments, torsion and frames, compared with closed forms and slow
//! references.

mod area;
mod even;
mod frames;
mod length;
