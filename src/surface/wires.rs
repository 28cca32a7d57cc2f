//! A surface as a mesh of its lines: tubes or ribbons along the isocurves.

use super::sweep::{Frame, Section, Sweep, turned};
use super::wireframe::Isocurve;
use super::{Indices, Mesh, PatchRange, Surface};
use crate::curve::{max_abs, ratio};
use crate::error::Error;
use crate::point::Point;
use glam::DVec3;
use std::f64::consts::PI;

/// The most vertices: each three positions, three normals and, nearly, two triangles of three indices, four bytes each,
/// in 1 GiB.
const MAX_VERTICES: u32 = (1 << 30) / ((3 + 3 + 6) * 4);

/// A ribbon follows its line as a tube of so many sides does.
const RIBBON_SIDES: usize = 8;

/// The least tolerance is four ulps of the largest coordinate.
const LEAST_ULPS: f64 = 4.0;

/// What a [`Surface::wireframe`] is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WireframeOptions {
    /// Strips per patch each way, at least 1.
    pub lines: usize,
    /// The body of each line.
    pub wire: Wire,
}

/// The body of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wire {
    /// A tube with round ends.
    Tube {
        /// Of the circle around the line that the corners lie on, in the surface's unit.
        radius: f64,
        /// Corners of the cross-section, at least 3.
        sides: usize,
    },
    /// A flat band in the surface's tangent planes.
    Ribbon {
        /// From edge to edge, in the surface's unit.
        width: f64,
    },
}

impl Default for WireframeOptions {
    /// Four strips; tubes of eight sides and the radius 0.01.
    fn default() -> Self {
        Self {
            lines: 4,
            wire: Wire::Tube {
                radius: 0.01,
                sides: 8,
            },
        }
    }
}

impl Surface {
    /// A mesh of the [`isocurves`](Self::isocurves): tubes, or ribbons that lie in the surface.
    ///
    /// A line is followed as closely as a tube's cross-section follows its circle: to r (1 − cos(π / sides)), with
    /// places between which it turns by at most 2π / sides (a ribbon as half as wide as a tube with eight sides). Where
    /// it turns back within that distance, at a cusp, it ends and starts anew. Tubes are closed bodies with round ends,
    /// which is how they meet where lines cross and patches end; their cross-sections do not twist about the line
    /// (rotation-minimising frames by double reflection). Ribbons have the surface's normals and one side, that of ∂u ×
    /// ∂v. A line that is a point gives nothing. `uvs` and `patch_ids` are empty; `patch_ranges` tell which patch has
    /// drawn what.
    ///
    /// Source of the frames: Wang, Jüttler, Zheng and Liu, "Computation of rotation minimizing frames", ACM
    /// Transactions on Graphics 27 (2008).
    ///
    /// ```
    /// use casteljau::surface::{Wire, WireframeOptions};
    /// use casteljau::{Surface, TeapotOptions};
    ///
    /// let teapot = Surface::teapot(TeapotOptions::default());
    /// let wire = Wire::Ribbon { width: 0.05 };
    /// let mesh = teapot.wireframe(&WireframeOptions { lines: 4, wire })?;
    /// assert!(mesh.triangle_count() > 2 * 260);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Range`] for 0 lines, fewer than 3 sides, a radius or a width that is not above 0, [`Error::Least`] for
    /// one so small that f32 cannot show it, [`Error::TooMany`] above 1 GiB.
    pub fn wireframe(&self, options: &WireframeOptions) -> Result<Mesh, Error> {
        let section = options.wire.section()?;
        let tracer = Tracer::new(self, &options.wire)?;
        self.check_least_count(options.lines, &section)?;
        // Counted first, so that nothing is allocated in vain.
        let mut sweep = Sweep::new(&section);
        let mut patch_ranges = vec![PatchRange::default(); self.patch_count()];
        self.draw_wires(options.lines, &tracer, &mut sweep, &mut patch_ranges)?;
        let count = sweep.vertices as usize;
        if sweep.vertices > MAX_VERTICES {
            return Err(too_many(count));
        }
        let mut sweep = Sweep::writing(&section, count);
        self.draw_wires(options.lines, &tracer, &mut sweep, &mut patch_ranges)?;
        Ok(Mesh {
            positions: sweep.positions,
            normals: sweep.normals,
            indices: Indices::smallest(sweep.indices, count),
            patch_ranges,
            ..Mesh::default()
        })
    }

    fn draw_wires(
        &self,
        lines: usize,
        tracer: &Tracer,
        sweep: &mut Sweep<'_>,
        ranges: &mut [PatchRange],
    ) -> Result<(), Error> {
        ranges.fill(PatchRange::default());
        let mut outcome = Ok(());
        self.each_isocurve(lines, &mut |line| {
            if outcome.is_ok() && sweep.vertices <= MAX_VERTICES {
                let (first_vertex, first_index) = (sweep.vertices, sweep.first_index());
                outcome = tracer.follow(&line, sweep);
                let range = &mut ranges[line.patch_number];
                if range.vertices == 0 {
                    (range.first_vertex, range.first_index) = (first_vertex, first_index);
                }
                range.vertices = sweep.vertices - range.first_vertex;
                range.indices = sweep.first_index() - range.first_index;
            }
        })?;
        outcome
    }

    /// Refuses lines that must be too many, without looking at one of them.
    fn check_least_count(&self, lines: usize, section: &Section) -> Result<(), Error> {
        let inside = lines
            .saturating_sub(1)
            .saturating_mul(2 * self.patch_count());
        let needed = inside.saturating_mul(section.least());
        if needed > MAX_VERTICES as usize {
            Err(too_many(needed))
        } else {
            Ok(())
        }
    }
}

fn too_many(needed: usize) -> Error {
    Error::TooMany {
        what: "vertices",
        limit: MAX_VERTICES as usize,
        needed,
    }
}

impl Wire {
    fn section(&self) -> Result<Section, Error> {
        let (what, size) = self.size();
        if !(size > 0.0 && size < f64::INFINITY) {
            return Err(Error::Range {
                what,
                expected: "a finite number above 0",
                got: size,
            });
        }
        match *self {
            Self::Tube { sides, .. } if sides < 3 => Err(Error::Range {
                what: "sides",
                expected: "a whole number from 3",
                got: ratio(sides, 1),
            }),
            Self::Tube { sides, .. } if sides > MAX_VERTICES as usize => Err(too_many(sides)),
            Self::Tube { radius, sides } => Ok(Section::tube(radius, sides)),
            Self::Ribbon { width } => Ok(Section::ribbon(width)),
        }
    }

    /// The size by its name.
    fn size(&self) -> (&'static str, f64) {
        match *self {
            Self::Tube { radius, .. } => ("radius", radius),
            Self::Ribbon { width } => ("width", width),
        }
    }
}

/// Walks along lines.
struct Tracer {
    tolerance: f64,
    /// The cosine of the greatest turn between two places.
    turn: f64,
    ribbon: bool,
}

/// A place on a line before its frame is known.
#[derive(Clone, Copy)]
struct Place {
    t: f64,
    point: DVec3,
    along: DVec3,
    /// The surface's normal under a ribbon, else zero.
    normal: DVec3,
}

impl Tracer {
    fn new(surface: &Surface, wire: &Wire) -> Result<Self, Error> {
        let (what, got) = wire.size();
        let (sides, radii) = match *wire {
            Wire::Tube { sides, .. } => (sides, 1.0),
            Wire::Ribbon { .. } => (RIBBON_SIDES, 0.5),
        };
        let bounds = surface.control_bounds();
        let size = bounds.map_or(0.0, |b| max_abs(&[b.min, b.max]));
        if size + got > f64::from(f32::MAX) {
            return Err(Error::Range {
                what: "vertices",
                expected: "coordinates that f32 can hold",
                got: size + got,
            });
        }
        // 1 − cos 2α = 2 sin² α, without cancellation.
        let [_, sine] = turned(0.5 * PI / ratio(sides, 1));
        let share = radii * 2.0 * sine * sine;
        let least = LEAST_ULPS * f64::from(f32::EPSILON) * size / share;
        if got < least {
            return Err(Error::Least { what, least, got });
        }
        Ok(Self {
            tolerance: got * share,
            turn: turned(2.0 * PI / ratio(sides, 1))[0],
            ribbon: matches!(wire, Wire::Ribbon { .. }),
        })
    }

    /// Moves the section along one line.
    fn follow(&self, line: &Isocurve<'_>, sweep: &mut Sweep<'_>) -> Result<(), Error> {
        if line.curve.tangent(0.0) == DVec3::ZERO {
            return Ok(());
        }
        let polyline = line.curve.flatten(self.tolerance)?;
        let mut before: Option<(Place, Frame)> = None;
        for (&t, &point) in polyline.ts.iter().zip(&polyline.points) {
            let place = self.look(line, t, point);
            before = Some(match before {
                None => self.start(place, sweep),
                Some(from) => self.advance(line, from, place, sweep),
            });
        }
        if let Some((_, frame)) = before {
            sweep.end(&frame);
        }
        Ok(())
    }

    fn look(&self, line: &Isocurve<'_>, t: f64, point: DVec3) -> Place {
        let (u, v) = if line.constant_u {
            (line.at, t)
        } else {
            (t, line.at)
        };
        Place {
            t,
            point,
            along: line.curve.tangent(t),
            normal: if self.ribbon {
                line.patch.normal(u, v)
            } else {
                DVec3::ZERO
            },
        }
    }

    fn start(&self, place: Place, sweep: &mut Sweep<'_>) -> (Place, Frame) {
        let frame = frame(&place, place.normal);
        sweep.begin(&frame);
        (place, frame)
    }

    /// Goes on to the next place, over as many between as the turn asks for.
    fn advance(
        &self,
        line: &Isocurve<'_>,
        (from, before): (Place, Frame),
        to: Place,
        sweep: &mut Sweep<'_>,
    ) -> (Place, Frame) {
        let straight =
            |a: DVec3, b: DVec3| a.dot(b) >= self.turn || a == DVec3::ZERO || b == DVec3::ZERO;
        if straight(from.along, to.along) && straight(from.normal, to.normal) {
            let side = if to.normal == DVec3::ZERO {
                carried(&before, &to)
            } else {
                to.normal
            };
            let frame = frame(&to, side);
            sweep.place(&frame);
            return (to, frame);
        }
        let middle = 0.5 * (from.t + to.t);
        let close = (to.point - from.point).norm() <= self.tolerance;
        if close || middle <= from.t || middle >= to.t {
            // A corner.
            sweep.end(&before);
            return self.start(to, sweep);
        }
        let middle = self.look(line, middle, line.curve.eval(middle));
        let half = self.advance(line, (from, before), middle, sweep);
        self.advance(line, half, to, sweep)
    }
}

/// The frame at a place, its side as near to the given direction as may be.
fn frame(place: &Place, side: DVec3) -> Frame {
    let Place { point, along, .. } = *place;
    let axis = if along.x.abs() < 0.5 {
        DVec3::X
    } else {
        DVec3::Y
    };
    let across = |v: DVec3| (v - along * v.dot(along)).unit();
    // Of a side almost along the line, rounding leaves some of it: twice is enough (Kahan).
    let side = across(across(side));
    let side = if side == DVec3::ZERO {
        across(across(axis))
    } else {
        side
    };
    Frame { point, along, side }
}

/// The side of a frame, carried to the next place without a turn about the line: reflected in the plane amid both
/// points, then in the one that takes the tangent to that of the next.
fn carried(from: &Frame, to: &Place) -> DVec3 {
    let reflect = |v: DVec3, normal: DVec3| v - normal * (2.0 * v.dot(normal));
    let chord = (to.point - from.point).unit();
    let (side, along) = (reflect(from.side, chord), reflect(from.along, chord));
    reflect(side, (to.along - along).unit())
}
