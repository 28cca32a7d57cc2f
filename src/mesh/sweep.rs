//! Sweeps of a cross-section along a line: rows of vertices and the faces between them.

use super::buffers::to_f32;
use crate::numeric::float::{as_f64, ratio};
use casteljau_kernels::numeric::order::to_u32;
use glam::DVec3;

/// A full turn in radians.
const TURN: f64 = std::f64::consts::TAU;

/// The cross-section that is swept along the line.
pub(crate) struct CrossSection {
    /// The radius of a tube, half the width of a ribbon.
    half: f64,
    /// The corners of a tube's cross-section as (cos φ, sin φ); none for a ribbon.
    corners: Vec<[f64; 2]>,
    /// The rings of a cap between the end of the line and the cap's pole, as (cos, sin) of their elevation.
    rings: Vec<[f64; 2]>,
}

/// A point of a line with its frame.
#[derive(Clone, Copy)]
pub(crate) struct SweepFrame {
    pub(crate) point: DVec3,
    /// The unit tangent.
    pub(crate) along: DVec3,
    /// A unit vector perpendicular to the tangent: the normal of a ribbon, or the direction of a tube's first corner.
    pub(crate) side: DVec3,
}

impl CrossSection {
    pub(crate) fn ribbon(width: f64) -> Self {
        Self {
            half: 0.5 * width,
            corners: Vec::new(),
            rings: Vec::new(),
        }
    }

    /// A tube with hemispheres at its ends; the rings of a hemisphere are about as far apart as the corners.
    pub(crate) fn tube(radius: f64, sides: usize) -> Self {
        // A quarter of the sides, rounded.
        let steps = ((sides + 2) / 4).max(1);
        let mut corners = Vec::with_capacity(sides);
        let [step_c, step_s] = cos_sin(TURN / as_f64(sides));
        let mut corner = [1.0, 0.0];
        for _ in 0..sides {
            corners.push(corner);
            let [c, s] = corner;
            corner = [c * step_c - s * step_s, c * step_s + s * step_c];
        }
        Self {
            half: radius,
            corners,
            rings: (1..steps)
                .map(|ring| cos_sin(0.25 * TURN * ratio(ring, steps)))
                .collect(),
        }
    }

    /// The number of vertices of a line with one sample.
    pub(crate) fn min_vertices(&self) -> usize {
        // The last two vertices are the poles of a tube, or the second row without which a ribbon has no faces.
        let rings = 1 + 2 * self.rings.len();
        self.columns() * rings + 2
    }

    fn is_tube(&self) -> bool {
        !self.corners.is_empty()
    }

    /// The number of vertices of a row.
    fn columns(&self) -> usize {
        self.corners.len().max(2)
    }
}

/// (cos φ, sin φ) of an angle up to a third of a turn, accurate to the last digits, from the power series of e to the
/// power iφ. The functions of the standard library would take a hundredth of the wasm module.
pub(crate) fn cos_sin(angle: f64) -> [f64; 2] {
    let mut sum = [1.0, 0.0];
    let mut term = 1.0;
    // (2π / 3) to the 27th over 27! is below 2⁻⁶⁴.
    for k in 1..=27 {
        term *= angle / f64::from(k);
        // iᵏ is real for even k, and its sign changes with every second k.
        let sign = if k / 2 % 2 == 1 { -1.0 } else { 1.0 };
        sum[usize::from(k % 2 == 1)] += sign * term;
    }
    sum
}

/// The row to which the next row is joined.
#[derive(Clone, Copy)]
enum PreviousRow {
    Nothing,
    /// A single vertex: its index.
    Pole(u32),
    /// A row of vertices of the section: the index of the first.
    Ring(u32),
}

/// The vertices and faces of a section that is swept along lines.
pub(crate) struct Sweep<'a> {
    section: &'a CrossSection,
    /// Whether vertices and faces are written; otherwise vertices are only counted.
    writes: bool,
    pub(crate) vertices: u32,
    pub(crate) positions: Vec<f32>,
    pub(crate) normals: Vec<f32>,
    pub(crate) indices: Vec<u32>,
    row: PreviousRow,
    start: u32,
}

impl<'a> Sweep<'a> {
    /// A sweep that only counts vertices.
    pub(crate) fn new(section: &'a CrossSection) -> Self {
        Self {
            section,
            writes: false,
            vertices: 0,
            positions: Vec::new(),
            normals: Vec::new(),
            indices: Vec::new(),
            row: PreviousRow::Nothing,
            start: 0,
        }
    }

    /// A sweep that writes this number of vertices.
    pub(crate) fn writing(section: &'a CrossSection, vertices: usize) -> Self {
        Self {
            writes: true,
            positions: Vec::with_capacity(3 * vertices),
            normals: Vec::with_capacity(3 * vertices),
            indices: Vec::with_capacity(6 * vertices),
            ..Self::new(section)
        }
    }

    /// The position of the next face in `indices`.
    pub(crate) fn first_index(&self) -> u32 {
        to_u32(self.indices.len())
    }

    /// Starts a line.
    pub(crate) fn begin(&mut self, frame: &SweepFrame) {
        self.row = PreviousRow::Nothing;
        self.start = self.vertices;
        if self.section.is_tube() {
            // From the pole to the line: the elevations of the rings in descending order.
            self.pole(frame, -1.0);
            for &[c, s] in self.section.rings.iter().rev() {
                self.ring(frame, [c, -s]);
            }
        }
        self.add_ring(frame);
    }

    /// Adds the next sample of the line.
    pub(crate) fn add_ring(&mut self, frame: &SweepFrame) {
        self.ring(frame, [1.0, 0.0]);
    }

    /// Ends the line at its last sample.
    pub(crate) fn end(&mut self, frame: &SweepFrame) {
        if self.section.is_tube() {
            for &elevation in &self.section.rings {
                self.ring(frame, elevation);
            }
            self.pole(frame, 1.0);
        } else if self.vertices == self.start + 2 {
            // A ribbon with a single row has no faces, so its vertices are removed.
            self.vertices = self.start;
            self.positions.truncate(3 * self.start as usize);
            self.normals.truncate(3 * self.start as usize);
        }
    }

    /// Adds a ring of a tube, whose radius and offset along the line follow from the elevation, or the two vertices of
    /// a ribbon, left and right.
    fn ring(&mut self, frame: &SweepFrame, [c, s]: [f64; 2]) {
        let first = self.vertices;
        let across = frame.along.cross(frame.side);
        if self.section.is_tube() {
            // Points of the sphere around the sample: c is the radius of its circle across the line, s the height.
            for &[x, y] in &self.section.corners {
                let normal = (frame.side * x + across * y) * c + frame.along * s;
                self.vertex(frame.point + normal * self.section.half, normal);
            }
        } else {
            let half = across * self.section.half;
            self.vertex(frame.point - half, frame.side);
            self.vertex(frame.point + half, frame.side);
        }
        self.join(PreviousRow::Ring(first));
    }

    fn pole(&mut self, frame: &SweepFrame, sense: f64) {
        let (normal, pole) = (frame.along * sense, self.vertices);
        self.vertex(frame.point + normal * self.section.half, normal);
        self.join(PreviousRow::Pole(pole));
    }

    fn vertex(&mut self, position: DVec3, normal: DVec3) {
        self.vertices = self.vertices.saturating_add(1);
        if self.writes {
            self.positions.extend(position.to_array().map(to_f32));
            self.normals.extend(normal.to_array().map(to_f32));
        }
    }

    /// Adds the faces between the previous row and this one, counter-clockwise as seen from outside.
    fn join(&mut self, next: PreviousRow) {
        let before = std::mem::replace(&mut self.row, next);
        if !self.writes {
            return;
        }
        let columns = self.section.columns();
        let faces = if self.section.is_tube() { columns } else { 1 };
        for k in 0..faces {
            let [here, beside] = [k, (k + 1) % columns].map(to_u32);
            match (before, next) {
                (PreviousRow::Ring(a), PreviousRow::Ring(b)) => {
                    // A quadrilateral with p and q on the previous row, r and s on this one.
                    let [p, q, r, s] = [a + here, a + beside, b + beside, b + here];
                    self.indices.extend([p, q, r, p, r, s]);
                }
                (PreviousRow::Pole(pole), PreviousRow::Ring(b)) => {
                    self.indices.extend([pole, b + beside, b + here]);
                }
                (PreviousRow::Ring(a), PreviousRow::Pole(pole)) => {
                    self.indices.extend([pole, a + here, a + beside]);
                }
                _ => (),
            }
        }
    }
}
