//! Hostile curves, each with a tolerance, and the measurements on them.

use crate::support::adversarial::{self, Kind};
use crate::support::measure::{Reference, farthest};
use crate::support::{Rng, Space, curve, largest, real, to_3d, ulp};
use casteljau::curve::Polyline;
use casteljau::glam::{DVec2, DVec3};

#[derive(Debug)]
pub(crate) struct Case {
    pub(crate) kind: Kind,
    pub(crate) points: Vec<DVec3>,
    pub(crate) dimension: usize,
    pub(crate) tolerance: f64,
}

impl Case {
    /// The i-th curve. The tolerance is 1 to 10⁻⁶ of its size, if the coordinates can resolve that.
    pub(crate) fn new(i: usize) -> Self {
        let mut rng = Rng(i as u64);
        let dimension = 2 + i % 2;
        let kind = adversarial::ALL[(i / 2) % adversarial::ALL.len()];
        let degree = degree(&mut rng);
        let points = adversarial::points(&mut rng, kind, degree, dimension);
        let min = 4.0 * ulp(largest(&points)).max(f64::MIN_POSITIVE);
        let tolerance = (size(&points) * rng.magnitude(-6.0, 0.0)).max(min);
        Self {
            kind,
            points,
            dimension,
            tolerance,
        }
    }

    /// The possible rounding of the vertices: an ulp, and more where they take many steps of de Casteljau's algorithm.
    fn rounding(&self) -> f64 {
        (1.0 + 0.5 * real(self.points.len() - 1)) * ulp(largest(&self.points))
    }

    /// The parameters and vertices, after the checks that need no measurement.
    pub(crate) fn flatten(&self) -> (Vec<f64>, Vec<DVec3>) {
        if self.dimension == 2 {
            self.flatten_in::<DVec2>()
        } else {
            self.flatten_in::<DVec3>()
        }
    }

    fn flatten_in<P: Space>(&self) -> (Vec<f64>, Vec<DVec3>) {
        let curve = curve::<P>(&self.points);
        let Polyline { points, ts } = curve.flatten(self.tolerance).expect("a fair tolerance");
        let last = ts.len() - 1;
        assert_eq!(points.len(), ts.len());
        assert_eq!((points[0], points[last]), (curve.start(), curve.end()));
        assert_eq!((ts[0], ts[last]), (0.0, 1.0));
        let increasing = ts.windows(2).all(|t| t[0] < t[1]);
        assert!(increasing, "{self:?}");
        // Vertices of cubics are computed from the nearest of some points.
        let rounding = 3.0 * self.rounding();
        let on_curve = |k: usize| points[k].distance(curve.eval(ts[k])) <= rounding;
        assert!((1..last).all(on_curve), "not on the curve: {self:?}");
        (ts, to_3d(&points))
    }

    /// Fails if the distance of the curve from the polyline exceeds the tolerance.
    pub(crate) fn check(&self) {
        let (ts, vertices) = self.flatten();
        let reference = Reference::new(&self.points);
        let vertices = reference.locations(&vertices);
        let allowed = reference.length(self.tolerance + self.rounding()) + reference.noise();
        let distance = farthest(&reference, &ts, &vertices, allowed);
        let (chords, share) = (ts.len() - 1, distance / reference.length(self.tolerance));
        let what = format!("{share} tolerances, {chords} chords: {self:?}");
        assert!(distance <= allowed, "{what}");
    }
}

/// Mostly 2 to 5, occasionally up to 64.
fn degree(rng: &mut Rng) -> usize {
    match rng.below(40) {
        0 | 1 => 1,
        2..8 => 2,
        8..28 => 3,
        28..34 => 4,
        34..38 => 5,
        _ if rng.chance(0.9) => 6 + rng.below(5),
        _ => 11 + rng.below(54),
    }
}

/// The diagonal of the bounding box of the control points.
fn size(points: &[DVec3]) -> f64 {
    let unit = largest(points);
    if unit == 0.0 {
        return 0.0;
    }
    let corner = |pick: fn(DVec3, DVec3) -> DVec3| {
        let all = points.iter().map(|&p| p / unit);
        all.reduce(pick).unwrap_or_default()
    };
    (corner(DVec3::max) - corner(DVec3::min)).length() * unit
}
