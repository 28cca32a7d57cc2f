//! Strokes: judged by the distance from the path, by closed forms, and by what a result promises.

mod cases;
mod contains;
mod dashes;
mod ink;
mod refusals;
mod resvg;
mod round;
mod round_corners;
mod shapes;
mod sides;
mod steps;
mod variable;
