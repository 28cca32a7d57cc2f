//! Curvature of a patch: principal, Gaussian and mean.

use super::Patch;
use super::tensor_product::{Partials, REGULAR_RATIO, directions};
use crate::geometry::point::Point;
use crate::surface::scaling::Scaling;
use glam::DVec3;

/// The curvatures of a surface at a point.
///
/// Positive values mean that the surface bends toward its normal ∂u × ∂v: both principal curvatures of a sphere of
/// radius r are −1/r where the normal points outwards, and 1/r where it points inwards.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Curvature {
    /// k1·k2, in 1/length². It does not depend on the orientation of the normal.
    pub gaussian: f64,
    /// (k1 + k2)/2, in 1/length.
    pub mean: f64,
    /// The larger principal curvature.
    pub k1: f64,
    /// The smaller principal curvature.
    pub k2: f64,
}

/// Step of the samples from which the limit is extrapolated where ∂u × ∂v vanishes, as a fraction of the distance to
/// the patch's middle (in parameters). The extrapolation error is proportional to its fourth power, and rounding errors
/// are divided by its square: both are about 1e-10.
const LIMIT_STEP: f64 = 1.0 / 256.0;

/// A limit is accepted if the nearest sample differs from it by at most this fraction of it. For a diverging 1/h the
/// difference is half of it.
const MAX_LIMIT_ERROR: f64 = 0.25;

/// A limit is also accepted if the difference is at most this, in units of 1/size: both values are then noise around
/// zero.
const LIMIT_NOISE: f64 = 1e-6;

impl Patch {
    /// The Gaussian, mean and principal curvatures at (u, v).
    ///
    /// They follow from the first and second fundamental forms E, F, G and L, M, N: gaussian = (LN − M²)/(EG − F²),
    /// mean = (EN − 2FM + GL)/(2(EG − F²)). They are computed from the matrix of the shape operator in an orthonormal
    /// frame, whose eigenvalues k1 ≥ k2 lose no digits. Units: 1/length, and 1/length² for the Gaussian curvature.
    ///
    /// Where ∂u × ∂v vanishes, as at a collapsed edge, they are the limits on the straight line from the patch's
    /// middle, extrapolated to about 8 digits. They are zero where there is no limit (the tip of a cone) and for a
    /// patch that is a curve or a point. Source: do Carmo, *Differential Geometry of Curves and Surfaces*, §3.3.
    pub fn curvature(&self, u: f64, v: f64) -> Curvature {
        let scaling = Scaling::around(self.control_bounds());
        let patch = scaling.image(self);
        curvature([u, v], scaling.size, |u, v| {
            patch.is_regular(u, v).then(|| patch.partials(u, v))
        })
    }

    /// Whether ∂u × ∂v exceeds rounding noise.
    pub(crate) fn is_regular(&self, u: f64, v: f64) -> bool {
        let (du, dv) = directions(&self.points, self.columns);
        let along_u = crate::patch::net::evaluate_net(&du, self.columns - 1, u, v);
        let along_v = crate::patch::net::evaluate_net(&dv, self.columns, u, v);
        Point::norm(along_u.cross(along_v)) > REGULAR_RATIO
    }
}

/// The curvatures at (u, v), divided by `size`, of a surface of size 1 whose `partials` are `None` where ∂u × ∂v vanishes.
pub(crate) fn curvature(
    [u, v]: [f64; 2],
    size: f64,
    partials: impl Fn(f64, f64) -> Option<Partials>,
) -> Curvature {
    let principal = |u: f64, v: f64| partials(u, v).and_then(|p| principal_curvatures(&p));
    let [k1, k2] = principal(u, v)
        .or_else(|| principal_limit(u, v, principal))
        .unwrap_or_default()
        .map(|k| k / size);
    Curvature {
        gaussian: k1 * k2,
        mean: 0.5 * (k1 + k2),
        k1,
        k2,
    }
}

/// k1 and k2 from partial derivatives of which the first ones are not parallel.
fn principal_curvatures(p: &Partials) -> Option<[f64; 2]> {
    let cross = p.u.cross(p.v);
    let normal = Point::unit(cross);
    // ∂u = a·e1 and ∂v = b·e1 + c·e2 with orthonormal vectors e1 and e2.
    let a = Point::norm(p.u);
    let (b, c) = (p.u.dot(p.v) / a, Point::norm(cross) / a);
    let [l, m, n] = [p.uu, p.uv, p.vv].map(|d: DVec3| d.dot(normal));
    let w11 = l / (a * a);
    let w12 = (m - b * l / a) / (a * c);
    let w22 = (n - b / a * (2.0 * m - b * l / a)) / (c * c);
    let (mean, half) = (0.5 * (w11 + w22), (0.5 * (w11 - w22)).hypot(w12));
    let k = [mean + half, mean - half];
    k.iter().all(|k| k.is_finite()).then_some(k)
}

/// k1 and k2, extrapolated along the straight line from (½, ½) in parameters.
fn principal_limit(
    u: f64,
    v: f64,
    principal: impl Fn(f64, f64) -> Option<[f64; 2]>,
) -> Option<[f64; 2]> {
    let mut limit = [0.0; 2];
    let mut nearest = [0.0; 2];
    // The cubic through the values at 1, 2, 3 and 4 steps, evaluated at 0.
    for (steps, weight) in [(4.0, -1.0), (3.0, 4.0), (2.0, -6.0), (1.0, 4.0)] {
        let toward_middle = |t: f64| t + (0.5 - t) * (steps * LIMIT_STEP);
        nearest = principal(toward_middle(u), toward_middle(v))?;
        for (sum, k) in limit.iter_mut().zip(nearest) {
            *sum += weight * k;
        }
    }
    let close = |(a, b): (&f64, &f64)| (a - b).abs() <= MAX_LIMIT_ERROR * a.abs() + LIMIT_NOISE;
    // k1 and k2 are extrapolated separately; where they are nearly equal, rounding may exchange them.
    let [k1, k2] = limit;
    let ordered = [k1.max(k2), k1.min(k2)];
    limit.iter().zip(&nearest).all(close).then_some(ordered)
}
