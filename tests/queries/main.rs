//! Queries on patches and surfaces: curvature, bounding boxes, area, volume, nearest points, rays.

#[path = "../nets/mod.rs"]
mod nets;

#[cfg(not(target_family = "wasm"))]
mod adversarial;
mod against_triangles;
mod bend;
mod bounds;
#[path = "../golden/mod.rs"]
mod golden;
#[path = "../listings/mod.rs"]
mod listings;
mod measure;
mod nearest;
mod rays;
mod shapes;
mod touches;
