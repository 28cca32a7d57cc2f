//! A camera's flight through points in space, at even speed and without a roll: one line a step, with the place, the
//! direction, and which way is up.
//!
//!     cargo run --example flight

use casteljau::glam::DVec3;
use casteljau::spline::Interpolation;
use casteljau::{Easing, Error, Spline};

/// Pictures of the flight.
const STEPS: usize = 24;

fn main() -> Result<(), Error> {
    let stops = [
        [0.0, 0.0, 1.0],
        [4.0, 1.0, 2.0],
        [6.0, 5.0, 2.5],
        [2.0, 7.0, 1.5],
        [-1.0, 4.0, 1.0],
    ]
    .map(DVec3::from);
    let path = Spline::interpolate(&stops, Interpolation::Natural, false)?;
    let length = path.length(None)?;
    println!("{length:.3} long, through {} points", stops.len());

    // It sets off and lands gently: the part of the way that is behind it, by the part of the time.
    let gently = Easing::new(0.42, 0.0, 0.58, 1.0)?;
    let times = (0..=STEPS)
        .map(|k| path.time_at_length(length * gently.eval(k as f64 / STEPS as f64), None))
        .collect::<Result<Vec<f64>, Error>>()?;
    for frame in path.frames_at(&times, Some(DVec3::Z))? {
        println!(
            "at {:6.3}  toward {:6.3}  up {:6.3}",
            frame.point, frame.tangent, frame.normal
        );
    }
    Ok(())
}
