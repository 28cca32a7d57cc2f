//! Wireframe meshes: tubes and ribbons along isocurves.

mod limits;
mod ribbons;
mod tubes;

use crate::support::wires::{euler, ribbons, tubes};
