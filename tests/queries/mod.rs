//! Queries on patches and surfaces: curvature, bounding boxes, area, volume, nearest points, rays.

#[cfg(not(target_family = "wasm"))]
mod adversarial;
mod against_triangles;
mod bend;
mod bounds;
mod measure;
mod nearest;
mod rays;
mod shapes;
mod touches;
