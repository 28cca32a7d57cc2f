//! Self-intersections of a curve.

use super::super::Curve;
use super::constants::{LOOP_HALVINGS, MAX_SEGMENTS, MIN_LOOP};
use super::intersection::{Intersection, IntersectionKind, SelfIntersection};
use super::pair::{ClassifiedContact, NormalizedPair};
use super::plane_curve::PlaneCurve;
use crate::curve::hodograph::is_monotone_along_chord;
use crate::curve::straight::Chord;
use crate::geometry::bounds::Bounds;
use crate::geometry::point::Point;
use glam::DVec2;

impl Curve<DVec2> {
    /// The points that the curve passes twice, sorted by t: B(t) = B(u) with 0 ≤ t < u ≤ 1.
    ///
    /// End points are included: a closed curve passes its start again, with t = 0 and u = 1. A point that the curve
    /// passes three times gives three pairs. A cusp is not a self-intersection, nor is a segment that the curve passes
    /// again: the list contains only isolated points, and a straight curve that reverses its direction has none.
    ///
    /// A cubic has at most one: with B = a t³ + b t² + c t + P₀ and σ = t + u, π = tu, (B(t) − B(u)) / (t − u) = a(σ² −
    /// π) + bσ + c vanishes for σ = −(a×c)/(a×b) and σ² − π = (b×c)/(a×b). Other curves are cut into segments without
    /// reversals, which are intersected with each other within the limit of [`intersections`](Self::intersections).
    pub fn self_intersections(&self) -> Vec<SelfIntersection> {
        self.self_contacts()
            .into_iter()
            .map(|Intersection { t, u, point, .. }| SelfIntersection { t, u, point })
            .collect()
    }

    /// [`self_intersections`](Self::self_intersections) with the kind of contact.
    pub(crate) fn self_contacts(&self) -> Vec<Intersection> {
        let contact = |location: ClassifiedContact| {
            let (t, u) = location.times();
            Intersection {
                t,
                u,
                // B(0) and B(1) are exact: control points.
                point: self.eval(if u == 1.0 { 1.0 } else { t }),
                kind: location.kind,
            }
        };
        self.self_locations().into_iter().map(contact).collect()
    }

    /// The parameters of the self-intersections.
    pub(crate) fn self_locations(&self) -> Vec<ClassifiedContact> {
        self_locations_of(self, |pair| {
            if self.degree() > 3 {
                return crossings(pair);
            }
            // The branches of a double point of a cubic have different directions.
            let cross = |times| ClassifiedContact::new(times, IntersectionKind::Cross);
            double_point(pair).map(cross).into_iter().collect()
        })
    }
}

/// The parameters of the self-intersections of a curve, by a search that may also find the two sides of a cusp.
pub(crate) fn self_locations_of<S: PlaneCurve>(
    curve: &S,
    search: impl Fn(&NormalizedPair<S>) -> Vec<ClassifiedContact>,
) -> Vec<ClassifiedContact> {
    if curve.points().len() < 4 || is_monotone_along_chord(curve.points()) {
        return Vec::new();
    }
    let Some(pair) = NormalizedPair::new(curve, curve) else {
        return Vec::new();
    };
    if Chord::of(pair.curves[0].points()).width <= pair.slack {
        return Vec::new();
    }
    let mut found = search(&pair);
    found.retain(|location| location.u - location.t > MIN_LOOP);
    found
}

/// The parameters of the double point of a cubic.
fn double_point(pair: &NormalizedPair<Curve<DVec2>>) -> Option<(f64, f64)> {
    let p = &pair.curves[0].points;
    let c = (p[1] - p[0]) * 3.0;
    let b = (p[2] - p[1]) * 3.0 - c;
    let a = p[3] - p[0] - c - b;
    let (ab, ac, bc) = (a.perp_dot(b), a.perp_dot(c), b.perp_dot(c));
    // (u − t)² = σ² − 4π = 4 (b×c)/(a×b) − 3σ²; NaN if this is negative. The midpoint is σ/2.
    let spread = (4.0 * bc * ab - 3.0 * ac * ac).sqrt() / ab.abs();
    let middle = -0.5 * ac / ab;
    let (t, u) = (middle - 0.5 * spread, middle + 0.5 * spread);
    // An end that rounding has moved outside is still an end.
    let near = |t: f64| t > -MIN_LOOP && t < 1.0 + MIN_LOOP;
    (spread > MIN_LOOP && near(t) && near(u))
        .then(|| pair.crossing((t.clamp(0.0, 1.0), u.clamp(0.0, 1.0))))?
        .map(|location| pair.snapped(location))
}

/// The self-intersections of a curve of any degree.
pub(crate) fn crossings(pair: &NormalizedPair<impl PlaneCurve>) -> Vec<ClassifiedContact> {
    let mut cuts = vec![0.0];
    let mut from = 0.0;
    for to in pair.curves[0].derivative_zeros().into_iter().chain([1.0]) {
        cut(pair, from, to, 0, &mut cuts);
        from = to;
    }
    let last = cuts.len() - 1;
    let boxes: Vec<Bounds<DVec2>> = cuts
        .windows(2)
        .map(|ends| Bounds::from_points(&pair.curves[0].part(ends[0], ends[1])))
        .collect();
    let touch = |&(i, j): &(usize, usize)| {
        let gap = boxes[i].min.max(boxes[j].min) - boxes[i].max.min(boxes[j].max);
        gap.max_element() <= pair.slack
    };
    // A segment that is monotone along its chord does not intersect itself, so i < j is enough.
    let pairs = (0..last).flat_map(|i| (i + 1..last).map(move |j| (i, j)));
    let pairs = pairs.filter(touch);
    let (found, _) = PlaneCurve::search(&pair.curves, pair.slack, [&cuts; 2], pairs);
    // Adjacent segments meet at their cut, which is not a self-intersection; the caller removes these.
    pair.locations(found)
        .into_iter()
        .filter(ClassifiedContact::is_point)
        .collect()
}

/// Cuts a segment until its parts have no reversals, and appends their ends.
fn cut(
    pair: &NormalizedPair<impl PlaneCurve>,
    from: f64,
    to: f64,
    depth: usize,
    cuts: &mut Vec<f64>,
) {
    let piece = pair.curves[0].part(from, to);
    let small = piece
        .iter()
        .all(|p| (*p - piece[0]).max_abs() <= pair.slack);
    let is_last = depth == LOOP_HALVINGS || cuts.len() >= MAX_SEGMENTS;
    if is_last || small || is_monotone_along_chord(&piece) {
        return cuts.push(to);
    }
    let middle = 0.5 * (from + to);
    cut(pair, from, middle, depth + 1, cuts);
    cut(pair, middle, to, depth + 1, cuts);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_with_coordinates_that_constructors_refuse() {
        for x in [f64::NAN, f64::INFINITY] {
            for degree in [3, 4, 64] {
                let points: Vec<DVec2> = (0..=degree)
                    .map(|k| DVec2::new(if k % 2 == 0 { x } else { -x }, f64::from(k)))
                    .collect();
                let curve = Curve::from_slice(&points);
                assert!(curve.self_intersections().len() <= MAX_SEGMENTS);
                assert!(curve.intersections(&curve).len() <= MAX_SEGMENTS);
                let distance = curve.distance_to(&curve.reverse()).distance;
                assert!(distance.is_nan() || distance >= 0.0);
            }
        }
    }
}
