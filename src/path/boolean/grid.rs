//! Polygons with corners on a grid in the place of outlines: the last resort, if their contacts contradict each other.
//!
//! The outlines are flattened and the corners rounded to the grid. Then lines are cut where they cross and where they
//! pass a corner within its cell, and the cuts are rounded, until there is nothing to cut: lines meet in common corners
//! only. In units of the grid all differences of coordinates are integers of at most 25 bits, so the side of a line on
//! which a point lies is exact. Source: Halperin and Packer, "Iterated snap rounding", Computational Geometry 23 (2002).

use super::contacts::{STEPS_PER_ITEM, steps_for};
use super::segments::{Segment, Segments};
use crate::bernstein::evaluate::evaluate;
use crate::geometry::bounds::Bounds;
use crate::geometry::box_tree::BoxTree;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::{as_f64, ratio, unit_scale};
use crate::numeric::sort::sort_by;
use glam::DVec2;
use std::iter::successors;

/// The larger side of the box around all outlines has 2²³ to 2²⁴ cells, or fewer where cells would be smaller than this
/// part of the largest coordinate: no corners are within ε of each other.
const CELLS: f64 = (1 << 23) as f64;
const SMALLEST_CELL: f64 = 1.0 / (1_u64 << 43) as f64;

/// The smallest and the largest distance of a polygon from its outline before its corners are rounded, in cells: 2⁻²⁰ and
/// 2⁻¹⁵ of the larger side. It is larger than the smallest one if there would be more chords than this number.
const DEVIATIONS: [f64; 2] = [8.0, 256.0];
const MANY_CHORDS: f64 = 2048.0;

/// The largest number of chords of all outlines together.
const MAX_CHORDS: usize = 1 << 22;

/// Each pass cuts lines into shorter ones. Mostly four or five are enough; nearly parallel lines may need hundreds.
const MAX_PASSES: usize = 1024;

/// A line from corner to corner, in units of the grid, and the segment that it is a part of.
#[derive(Clone, Copy)]
struct Line {
    ends: [DVec2; 2],
    segment: usize,
    /// The number of the next line of the outlines; after the last one a number that no line has.
    next: usize,
}

impl Segments {
    /// Polygons within about 2⁻¹⁵ of the size of the segments, whose lines meet in common corners only.
    ///
    /// # Errors
    /// [`Error::TooMany`] for more than 2²² chords, too many pairs of lines that may cross, or more than 1024 passes.
    pub(super) fn on_grid(&self) -> Result<Self, Error> {
        let Some(all) = self.bounds() else {
            return Err(Error::too_many("passes of the division on a grid", 0, 1)); // no segments, no contradiction
        };
        let size = (all.max - all.min).max_element();
        let cells = (CELLS * unit_scale(size)).min(1.0 / SMALLEST_CELL);
        let lines = noded(self.chords(all, cells)?)?;
        let mut polygons = Self {
            list: Vec::with_capacity(lines.len()),
            joints: Vec::with_capacity(lines.len()),
            path_count: self.path_count,
            roles: self.roles.clone(),
            unit: 1.0,
            epsilon: self.epsilon,
        };
        let ends: Vec<[DVec2; 2]> = lines
            .iter()
            .map(|line| line.ends.map(|p| all.min + p / cells))
            .collect();
        let mut from = 0;
        for subpath in self.list.chunk_by(|_, next| !next.is_first) {
            let last = &subpath[subpath.len() - 1];
            let end = from + subpath.len();
            let own = |line: &Line| line.segment < end;
            let range =
                lines.partition_point(|line| line.segment < from)..lines.partition_point(own);
            let curves = ends[range].iter().map(|ends| &ends[..]);
            polygons.push_subpath(curves, last.path, !last.is_last);
            from = end;
        }
        polygons.unit = self.unit;
        Ok(polygons)
    }

    /// The chords of the segments between rounded corners. Equal steps of √(n(n−1)/8 · |Δ²P| / tolerance) are sufficient
    /// (Wang, "The subdivision method for finding the intersection between two Bézier curves or surfaces", 1984).
    fn chords(&self, all: Bounds<DVec2>, cells: f64) -> Result<Vec<Line>, Error> {
        let last = ((all.max - all.min) * cells).floor();
        let [finest, coarsest] = DEVIATIONS;
        let counts = self
            .list
            .iter()
            .map(|curve| chord_count(curve, cells / finest));
        let many = counts.map(as_f64).sum::<f64>() / MANY_CHORDS;
        let deviation = (finest * many * many).clamp(finest, coarsest);
        let mut lines = Vec::new();
        for (segment, curve) in self.list.iter().enumerate() {
            let steps = chord_count(curve, cells / deviation);
            let needed = lines.len().saturating_add(steps);
            if needed > MAX_CHORDS {
                return Err(Error::too_many(
                    "chords of the outlines",
                    MAX_CHORDS,
                    needed,
                ));
            }
            let corner = |k| {
                let p = evaluate(&curve.points, ratio(k, steps)) - all.min;
                (p * cells).round().min(last).max(DVec2::ZERO)
            };
            let mut from = corner(0);
            for k in 1..=steps {
                let to = corner(k);
                if to != from {
                    lines.push(Line {
                        ends: [from, to],
                        segment,
                        next: lines.len() + 1,
                    });
                }
                from = to;
            }
        }
        Ok(lines)
    }
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

/// The lines, cut until they meet in common corners only.
///
/// A line that is cut keeps its number for its first part; the other parts get new numbers. After the first pass only
/// lines that were cut are compared, with all. Nearly parallel lines may need hundreds of passes that cut a few lines
/// each, so the added lines get trees of their own; a tree is built again with those after it when they have half as many
/// lines, and each line is in O(log n) built trees.
fn noded(mut lines: Vec<Line>) -> Result<Vec<Line>, Error> {
    if let Some(last) = lines.last_mut() {
        last.next = usize::MAX;
    }
    let mut work = steps_for(lines.len());
    let mut changed: Vec<usize> = (0..lines.len()).collect();
    // The pass before which each line was cut.
    let mut cut_before = vec![0; lines.len()];
    // Trees of consecutive lines, each with more than twice as many as the next one. Lines only get shorter, so the boxes
    // still contain them.
    let mut trees = vec![(0, tree_of(lines.iter()))];
    for pass in 0..MAX_PASSES {
        let of_changed = tree_of(changed.iter().map(|&k| &lines[k]));
        let mut cuts = Vec::new();
        for (first, tree) in &trees {
            tree.pairs_with(&of_changed, &mut work, |i, j| {
                let (i, j) = (first + i, changed[j]);
                // Two lines that were cut are found twice.
                if i < j || cut_before[i] != pass {
                    cut_pair(&lines, [i, j], &mut cuts);
                }
            });
        }
        Error::unless_within("steps of the division on a grid", &work)?;
        if cuts.is_empty() {
            let number = |k: usize| (k < lines.len()).then_some(k);
            let order = successors(number(0), |&k| number(lines[k].next));
            return Ok(order.map(|k| lines[k]).collect());
        }
        work.raise_limit(STEPS_PER_ITEM, cuts.len());
        let mut first = lines.len();
        changed = cut(&mut lines, cuts);
        cut_before.resize(lines.len(), 0);
        changed.iter().for_each(|&k| cut_before[k] = pass + 1);
        if lines.len() > MAX_CHORDS {
            let needed = lines.len();
            return Err(Error::too_many(
                "chords of the outlines",
                MAX_CHORDS,
                needed,
            ));
        }
        while let Some(&(start, _)) = trees.last()
            && 2 * (lines.len() - first) >= first - start
        {
            first = start;
            trees.pop();
        }
        if first < lines.len() {
            trees.push((first, tree_of(lines[first..].iter())));
        }
    }
    let passes = "passes of the division on a grid";
    Err(Error::too_many(passes, MAX_PASSES, MAX_PASSES + 1))
}

fn tree_of<'a>(lines: impl Iterator<Item = &'a Line>) -> BoxTree {
    let boxes: Vec<_> = lines.map(|line| Bounds::from_points(&line.ends)).collect();
    BoxTree::new(&boxes)
}

/// Adds the corners at which two lines are cut: ends of the other one in whose cell a line runs, and their crossing.
fn cut_pair(lines: &[Line], pair: [usize; 2], cuts: &mut Vec<(usize, DVec2)>) {
    let [a, b] = pair.map(|k| lines[k].ends);
    let mut add = |k: usize, p: DVec2| {
        if !lines[k].ends.contains(&p) {
            cuts.push((k, p));
        }
    };
    let heights_of_a = heights(b, a);
    let heights_of_b = heights(a, b);
    for (k, line, points, heights) in [(pair[0], a, b, heights_of_b), (pair[1], b, a, heights_of_a)]
    {
        let chord = (line[1] - line[0]).abs();
        let reach = 0.5 * (chord.x + chord.y);
        for (p, height) in points.into_iter().zip(heights) {
            if height.abs() < reach && Bounds::from_points(&line).contains(p) {
                add(k, p);
            }
        }
    }
    let crosses = |[from, to]: [f64; 2]| from < 0.0 && to > 0.0 || from > 0.0 && to < 0.0;
    if crosses(heights_of_a) && crosses(heights_of_b) {
        let [from, to] = heights_of_a;
        let p = a[0].lerp(a[1], from / (from - to)).round();
        pair.into_iter().for_each(|k| add(k, p));
    }
}

/// The distances of two points from a line, times its length; exact.
fn heights(line: [DVec2; 2], points: [DVec2; 2]) -> [f64; 2] {
    points.map(|p| (line[1] - line[0]).perp_dot(p - line[0]))
}

/// Cuts lines at corners; returns the numbers of all their parts.
fn cut(lines: &mut Vec<Line>, mut cuts: Vec<(usize, DVec2)>) -> Vec<usize> {
    let along = |&(k, p): &(usize, DVec2)| {
        let [from, to] = lines[k].ends;
        (p - from).dot(to - from)
    };
    sort_by(&mut cuts, |a, b| {
        a.0.cmp(&b.0).then(along(a).total_cmp(&along(b)))
    });
    let mut changed = Vec::with_capacity(2 * cuts.len());
    for own in cuts.chunk_by(|a, b| a.0 == b.0) {
        let mut number = own[0].0;
        let line = lines[number];
        let [start, end] = line.ends;
        let mut from = start;
        for to in own.iter().map(|cut| cut.1).chain([end]) {
            if to == from {
                continue;
            }
            if from != start {
                lines[number].next = lines.len();
                number = lines.len();
                lines.push(line);
            }
            lines[number].ends = [from, to];
            changed.push(number);
            from = to;
        }
    }
    changed
}

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
        let polygons = segments.on_grid().expect("few chords");
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

    /// A cubic beside itself at a distance of 10⁻⁸ of the size, and with many crossings of a star.
    #[test]
    fn lines_meet_in_common_corners_only() {
        let all = lines(
            "M0 0C30 90 60-80 100 20C60-80.000001 30 90.000001 0 0Z M0 10L90 60L10 50L95 5L3 33L77 71L50-9Z",
        );
        assert!(all.len() > 500, "{} lines", all.len());
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
}
