//! The last resort, where the contacts of segments contradict each other: lines with corners on a grid in the place of
//! segments.
//!
//! It is reached by none of the 1,108 drawings of other libraries' tests (tests/data/boolean, both fill rules) and none
//! of the pairs of tests/path_boolean, but by 1,045 of 162,000 generated calls: 1 % of those that have features of all sizes
//! down to 10⁻¹² of the drawing, and 0.3 % of the others, whose segments often touch or coincide.
//!
//! This is snap rounding. The segments are flattened and the corners rounded to the centres of the cells of a grid. Then
//! every line is led through the centres of all cells that it passes and in which another line ends or crosses a line.
//! Such lines do not cross: they meet in common corners only. In units of the grid all differences of coordinates are
//! integers of at most 25 bits, so the side of a line on which a point lies is exact. Sources: Hobby, "Practical segment
//! intersection with finite precision output", Computational Geometry 13 (1999), §2; Guibas and Marimont, "Rounding
//! arrangements dynamically", SoCG 1995.

use super::contacts::{STEPS_PER_ITEM, search_limit};
use super::segments::{Segment, Segments};
use crate::bernstein::evaluate::evaluate;
use crate::geometry::bounds::Bounds;
use crate::geometry::box_tree::BoxTree;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::{as_f64, ratio, unit_scale};
use crate::numeric::list::{Points, points_of};
use crate::numeric::sort::sort_by;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use glam::DVec2;

/// The larger side of the box around all outlines has 2²³ to 2²⁴ cells, or fewer where cells would be smaller than this
/// part of the largest coordinate: no corners are within ε of each other.
const CELLS: f64 = (1 << 23) as f64;
const SMALLEST_CELL: f64 = 1.0 / (1_u64 << 43) as f64;

/// The smallest and the largest distance of the lines from their segment before their corners are rounded, in cells: 2⁻²⁰
/// and 2⁻¹⁵ of the larger side. It is larger than the smallest one if there would be more chords than this number.
const DEVIATIONS: [f64; 2] = [8.0, 256.0];
const MANY_CHORDS: f64 = 2048.0;

/// The largest number of lines in the place of all segments, and of their corners.
const MAX_LINES: usize = 1 << 22;

/// What lines on the grid replace.
pub(super) struct ReplacedSegments {
    pub(super) segments: Vec<bool>,
    /// The joints that are rounded to the grid; all segments that end there are replaced. Other ends keep their bits.
    pub(super) joints: Vec<bool>,
}

impl ReplacedSegments {
    pub(super) fn all(segments: &Segments) -> Self {
        Self {
            segments: vec![true; segments.list.len()],
            joints: vec![true; segments.joints.len()],
        }
    }
}

/// A line from corner to corner, in units of the grid, and the segment that it is a part of.
#[derive(Clone, Copy)]
struct GridLine {
    ends: [DVec2; 2],
    segment: usize,
}

impl Segments {
    /// The segments with lines within about 2⁻¹⁵ of the size in the place of some.
    ///
    /// # Errors
    /// [`Error::TooMany`] for more than 2²² lines or corners, or too many pairs of lines that may cross.
    pub(super) fn on_grid(&self, mut replaced: ReplacedSegments) -> Result<Self, Error> {
        #[cfg(feature = "count-work")]
        total::count(replaced.segments.iter().filter(|&&is| is).count());
        self.replace_noded(&mut replaced);
        let nothing = Bounds::from_points(&[DVec2::ZERO]);
        let all = self.bounds().unwrap_or(nothing);
        let size = (all.max - all.min).max_element();
        let cells = (CELLS * unit_scale(size)).min(1.0 / SMALLEST_CELL);
        let lines = noded(self.chords(&replaced, all, cells)?)?;
        let mut mixed = Self {
            list: Vec::with_capacity(self.list.len() + lines.len()),
            joints: Vec::with_capacity(self.list.len() + lines.len()),
            path_count: self.path_count,
            roles: self.roles.clone(),
            // The points are scaled already.
            unit: 1.0,
            epsilon: self.epsilon,
        };
        let mut rest = &lines[..];
        let mut from = 0;
        for subpath in self.list.chunk_by(|_, next| !next.is_first) {
            let mut curves: Vec<(Points<DVec2>, bool)> = Vec::with_capacity(subpath.len());
            for (k, segment) in subpath.iter().enumerate() {
                if !replaced.segments[from + k] {
                    curves.push((segment.points.clone(), false));
                    continue;
                }
                let count = rest.partition_point(|line| line.segment <= from + k);
                let (own, others) = rest.split_at(count);
                rest = others;
                let [start, end] = [segment.start(), segment.end()];
                let mut ends: Vec<[DVec2; 2]> = own
                    .iter()
                    .map(|line| line.ends.map(|p| all.min + p / cells))
                    .collect();
                if ends.is_empty() {
                    let p = all.min + cell_of(start, all, cells) / cells;
                    ends.push([p; 2]);
                }
                let last = ends.len() - 1;
                let keeps = segment.ends.map(|joint| !replaced.joints[joint]);
                // A line to an end that keeps its bits is off the grid, so it is not noded.
                if keeps[0] {
                    ends[0][0] = start;
                }
                if keeps[1] {
                    ends[last][1] = end;
                }
                curves.extend(ends.iter().enumerate().map(|(k, ends)| {
                    let is_moved = k == 0 && keeps[0] || k == last && keeps[1];
                    (points_of(ends), !is_moved)
                }));
            }
            let last = &subpath[subpath.len() - 1];
            let curves = curves
                .iter()
                .map(|(points, is_noded)| (&points[..], *is_noded));
            mixed.push_subpath(curves, last.path, !last.is_last);
            from += subpath.len();
        }
        mixed.unit = self.unit;
        Ok(mixed)
    }

    /// Adds the lines of an earlier division, which have to meet the new ones in common corners too.
    fn replace_noded(&self, replaced: &mut ReplacedSegments) {
        let mut joins_noded = vec![true; self.joints.len()];
        let others = self.list.iter().filter(|segment| !segment.is_noded);
        for joint in others.flat_map(|segment| segment.ends) {
            joins_noded[joint] = false;
        }
        for (segment, is_replaced) in self.list.iter().zip(&mut replaced.segments) {
            *is_replaced |= segment.is_noded;
        }
        for (is_replaced, joins_noded) in replaced.joints.iter_mut().zip(joins_noded) {
            *is_replaced |= joins_noded;
        }
    }

    /// The chords of the replaced segments between rounded corners. Equal steps of √(n(n−1)/8 · |Δ²P| / tolerance) are
    /// sufficient (Wang, "The subdivision method for finding the intersection between two Bézier curves or surfaces",
    /// 1984).
    fn chords(
        &self,
        replaced: &ReplacedSegments,
        all: Bounds<DVec2>,
        cells: f64,
    ) -> Result<Vec<GridLine>, Error> {
        let curves = || {
            let all = self.list.iter().enumerate();
            all.filter(|&(segment, _)| replaced.segments[segment])
        };
        let [finest, coarsest] = DEVIATIONS;
        let counts = curves().map(|(_, curve)| chord_count(curve, cells / finest));
        // The number of chords is proportional to √(1/deviation), so finest · many² would give MANY_CHORDS.
        let many = counts.map(as_f64).sum::<f64>() / MANY_CHORDS;
        let deviation = (finest * many * many).clamp(finest, coarsest);
        let mut lines = Vec::new();
        for (segment, curve) in curves() {
            let steps = chord_count(curve, cells / deviation);
            check_count("chords of the outlines", lines.len().saturating_add(steps))?;
            let corner = |k| cell_of(evaluate(&curve.points, ratio(k, steps)), all, cells);
            let mut from = corner(0);
            for k in 1..=steps {
                let to = corner(k);
                if to != from {
                    lines.push(GridLine {
                        ends: [from, to],
                        segment,
                    });
                }
                from = to;
            }
        }
        Ok(lines)
    }
}

/// The cell of a point in the box around all segments, in units of the grid.
fn cell_of(p: DVec2, all: Bounds<DVec2>, cells: f64) -> DVec2 {
    let last = ((all.max - all.min) * cells).floor();
    ((p - all.min) * cells).round().min(last).max(DVec2::ZERO)
}

#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a square root, at least 1; a count that is too large is refused"
)]
fn chord_count(curve: &Segment, per_deviation: f64) -> usize {
    let second = |p: &[DVec2]| Point::norm((p[2] - p[1]) - (p[1] - p[0]));
    let largest = curve.points.windows(3).map(second).fold(0.0, f64::max);
    let n = (curve.points.len() - 1) as f64;
    let steps = (n * (n - 1.0) * 0.125 * largest * per_deviation).sqrt();
    steps.ceil().max(1.0) as usize
}

fn check_count(what: &'static str, count: usize) -> Result<(), Error> {
    if count > MAX_LINES {
        return Err(Error::too_many(what, MAX_LINES, count));
    }
    Ok(())
}

/// The lines, led through the cells in which lines end or cross, so that they meet in common corners only.
fn noded(lines: Vec<GridLine>) -> Result<Vec<GridLine>, Error> {
    let mut work = search_limit(lines.len());
    let corners = corners(&lines, &mut work)?;
    let boxes: Vec<_> = corners.iter().map(|&p| Bounds::from_points(&[p])).collect();
    let tree = BoxTree::new(&boxes);
    let through_cells = cut_at_corners(&lines, (&corners, &tree), passes_cell, &mut work)?;
    // A line that was moved may run exactly through the centre of a cell that it did not pass before.
    cut_at_corners(&through_cells, (&corners, &tree), passes_centre, &mut work)
}

fn tree_of(lines: &[GridLine]) -> BoxTree {
    let bounds = |line: &GridLine| Bounds::from_points(&line.ends);
    let boxes: Vec<_> = lines.iter().map(bounds).collect();
    BoxTree::new(&boxes)
}

/// The cells in which lines end or cross, each once.
fn corners(lines: &[GridLine], work: &mut WorkLimit) -> Result<Vec<DVec2>, Error> {
    let mut corners: Vec<DVec2> = lines.iter().flat_map(|line| line.ends).collect();
    keep_different(&mut corners);
    tree_of(lines).pairs_within(work, |i, j, work| {
        if let Some(p) = crossing(lines[i].ends, lines[j].ends) {
            corners.push(p);
            work.raise_limit(STEPS_PER_ITEM, 1);
            // Many crossings may be in the same few cells.
            if corners.len() > 2 * MAX_LINES {
                keep_different(&mut corners);
                if corners.len() > MAX_LINES {
                    work.stop();
                }
            }
        }
    });
    keep_different(&mut corners);
    check_count("corners of the division on a grid", corners.len())?;
    Error::unless_within("steps of the division on a grid", work)?;
    Ok(corners)
}

fn keep_different(corners: &mut Vec<DVec2>) {
    sort_by(corners, |p, q| {
        p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y))
    });
    corners.dedup();
}

/// The cell in which two lines cross, if they do.
fn crossing(a: [DVec2; 2], b: [DVec2; 2]) -> Option<DVec2> {
    let crosses = |[from, to]: [f64; 2]| from < 0.0 && to > 0.0 || from > 0.0 && to < 0.0;
    let [from, to] = heights(b, a);
    // The lines cross at a₀ + (a₁ − a₀) · from / (from − to).
    let steps = (a[1] - a[0]).to_array();
    (crosses([from, to]) && crosses(heights(a, b))).then(|| {
        a[0] + DVec2::from_array(steps.map(|step| rounded_quotient(step, from, from - to)))
    })
}

/// The product a b / c of integers of up to 2²⁵, 2⁵¹ and 2⁵² rounded to the nearest integer, exactly; one in the middle is
/// rounded up.
#[allow(
    clippy::cast_possible_truncation,
    reason = "integers of at most 53 bits"
)]
fn rounded_quotient(a: f64, b: f64, c: f64) -> f64 {
    let (b, c) = (b * c.signum(), c.abs());
    let whole = |x: f64| i128::from(x as i64);
    let twice = 2 * whole(a) * whole(b);
    // The quotient of rounded numbers may be wrong by 1 next to the middle of two integers.
    let mut n = (a * b / c).round();
    if twice < (2 * whole(n) - 1) * whole(c) {
        n -= 1.0;
    } else if twice >= (2 * whole(n) + 1) * whole(c) {
        n += 1.0;
    }
    n
}

/// The distances of two points from a line, times its length; exact.
fn heights(line: [DVec2; 2], points: [DVec2; 2]) -> [f64; 2] {
    points.map(|p| (line[1] - line[0]).perp_dot(p - line[0]))
}

/// Whether a line passes the cell with the centre p: a square of side 1 with its left and its lower side. The box of the
/// line contains p.
fn passes_cell([from, to]: [DVec2; 2], p: DVec2) -> bool {
    let chord = to - from;
    let twice = 2.0 * chord.perp_dot(p - from);
    // On the other side of the equation is the height of the lower left corner over p.
    twice.abs() < chord.x.abs() + chord.y.abs() || twice == chord.x - chord.y
}

/// Whether a line passes the point p in its box.
fn passes_centre([from, to]: [DVec2; 2], p: DVec2) -> bool {
    (to - from).perp_dot(p - from) == 0.0
}

/// The lines with further corners where they pass one.
fn cut_at_corners(
    lines: &[GridLine],
    (corners, tree): (&[DVec2], &BoxTree),
    passes: impl Fn([DVec2; 2], DVec2) -> bool,
    work: &mut WorkLimit,
) -> Result<Vec<GridLine>, Error> {
    let mut cuts: Vec<(usize, DVec2)> = Vec::new();
    let mut needed = lines.len();
    tree_of(lines).pairs_with(tree, work, |line, corner| {
        let (ends, p) = (lines[line].ends, corners[corner]);
        if !ends.contains(&p) && passes(ends, p) {
            needed += 1;
            if needed <= MAX_LINES {
                cuts.push((line, p));
            }
        }
    });
    check_count("lines of the division on a grid", needed)?;
    Error::unless_within("steps of the division on a grid", work)?;
    let along = |&(k, p): &(usize, DVec2)| {
        let [from, to] = lines[k].ends;
        (p - from).dot(to - from)
    };
    sort_by(&mut cuts, |a, b| {
        a.0.cmp(&b.0).then(along(a).total_cmp(&along(b)))
    });
    let mut parts = Vec::with_capacity(needed);
    let mut rest = cuts.iter().peekable();
    for (k, line) in lines.iter().enumerate() {
        let [mut from, end] = line.ends;
        let own = std::iter::from_fn(|| rest.next_if(|cut| cut.0 == k));
        for to in own.map(|cut| cut.1).chain([end]) {
            parts.push(GridLine {
                ends: [from, to],
                ..*line
            });
            from = to;
        }
    }
    Ok(parts)
}

/// With the feature `count-work`, the replaced segments of all calls are added up for each thread, so that tests can check
/// that lines replace few.
#[cfg(feature = "count-work")]
mod total {
    use std::cell::Cell;

    thread_local! {
        static REPLACED: Cell<usize> = const { Cell::new(0) };
    }

    pub(super) fn count(segments: usize) {
        REPLACED.with(|replaced| replaced.set(replaced.get().saturating_add(segments)));
    }

    /// The segments that lines replaced on this thread since the last call of this function.
    pub fn take_replaced_segments() -> usize {
        REPLACED.with(|replaced| replaced.replace(0))
    }
}

#[cfg(feature = "count-work")]
pub use total::take_replaced_segments;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::Path;
    use crate::path::boolean::segments::Role;

    /// The lines of polygons in whole cells.
    #[allow(clippy::cast_possible_truncation, reason = "whole numbers below 2^25")]
    fn lines(text: &str) -> Vec<[[i128; 2]; 2]> {
        let path: Path = text.parse().expect("path data");
        let segments = Segments::new(&[(&path, Role::Region)]).expect("few segments");
        let polygons = segments
            .on_grid(ReplacedSegments::all(&segments))
            .expect("few chords");
        let size = segments.bounds().expect("segments");
        let cells = CELLS * unit_scale((size.max - size.min).max_element());
        let whole = |p: DVec2| {
            ((p - size.min) * cells)
                .round()
                .to_array()
                .map(|x| x as i128)
        };
        let ends = |segment: &Segment| [segment.start(), segment.end()].map(whole);
        polygons.list.iter().map(ends).collect()
    }

    fn side([a, b]: [[i128; 2]; 2], p: [i128; 2]) -> i128 {
        ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])).signum()
    }

    fn between([a, b]: [[i128; 2]; 2], p: [i128; 2]) -> bool {
        (0..2).all(|k| a[k].min(b[k]) <= p[k] && p[k] <= a[k].max(b[k]))
    }

    fn check(all: &[[[i128; 2]; 2]]) {
        for (k, a) in all.iter().enumerate() {
            for b in &all[..k] {
                for (line, points) in [(a, b), (b, a)] {
                    for p in points {
                        let inside = side(*line, *p) == 0 && between(*line, *p);
                        assert!(!inside || line.contains(p), "{p:?} on {line:?}");
                    }
                }
                let crosses = |line: &[[i128; 2]; 2], points: &[[i128; 2]; 2]| {
                    side(*line, points[0]) * side(*line, points[1]) < 0
                };
                assert!(!(crosses(a, b) && crosses(b, a)), "{a:?} crosses {b:?}");
            }
        }
    }

    /// A cubic beside itself at a distance of 10⁻⁸ of the size, and with many crossings of a star.
    #[test]
    fn lines_meet_in_common_corners_only() {
        let all = lines(
            "M0 0C30 90 60-80 100 20C60-80.000001 30 90.000001 0 0Z M0 10L90 60L10 50L95 5L3 33L77 71L50-9Z",
        );
        assert!(all.len() > 500, "{} lines", all.len());
        check(&all);
    }

    /// Lines of 2²³ cells that cross each other in a strip of some cells, again and again where one was rounded.
    #[test]
    fn nearly_parallel_lines_meet_in_common_corners_only() {
        let mut text = "M0 0".to_string();
        for k in 0..24 {
            let height = f64::from(k * 7 % 24) * 2e-6 + f64::from(k % 2) * 3e-5;
            text += &format!("L{} {height}", 100 * ((k + 1) % 2));
        }
        let all = lines(&text);
        assert!(all.len() > 200, "{} lines", all.len());
        check(&all);
    }

    #[test]
    fn quotients_are_rounded_exactly() {
        let largest = (1_i64 << 51) as f64;
        // In the middle of two integers, and next to it by one part in 2⁵¹.
        assert_eq!(rounded_quotient(1.0, 1.0, 2.0), 1.0);
        assert_eq!(rounded_quotient(-1.0, 1.0, 2.0), 0.0);
        assert_eq!(rounded_quotient(3.0, largest - 1.0, 2.0 * largest), 1.0);
        assert_eq!(rounded_quotient(3.0, -largest - 1.0, 2.0 * largest), -2.0);
        assert_eq!(
            rounded_quotient(33_554_431.0, largest - 1.0, 2.0 * largest),
            16_777_215.0
        );
    }
}
