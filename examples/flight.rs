//! A camera path through points in space, with eased motion and rotation-minimising frames. Prints one line per step:
//! the position, the direction and the up vector.
//!
//!     cargo run --example flight

use casteljau::glam::DVec3;
use casteljau::spline::Interpolation;
use casteljau::{Easing, Error, Spline};

/// The number of steps.
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
    let length = path.length();
    println!("{length:.3} long, through {} points", stops.len());

    // The easing function maps the ratio of time to the ratio of arc length, so that the motion starts and ends slowly.
    let gently = Easing::new(0.42, 0.0, 0.58, 1.0)?;
    let times = (0..=STEPS)
        .map(|k| path.time_at_length(length * gently.eval(k as f64 / STEPS as f64)))
        .collect::<Vec<f64>>();
    for frame in path.frames_at(&times, Some(DVec3::Z))? {
        println!(
            "at {:6.3}  toward {:6.3}  up {:6.3}",
            frame.point, frame.tangent, frame.normal
        );
    }
    Ok(())
}
