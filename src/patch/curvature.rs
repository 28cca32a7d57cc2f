//! How does the surface bend?

use super::Patch;
use super::tensor_product::{REGULAR_RATIO, directions};
use crate::geometry::point::Point;
use crate::surface::frame::Frame;
use glam::DVec3;

/// The curvatures of a surface at a point.
///
/// They are positive where the surface bends toward its normal ∂u × ∂v: a sphere of radius r has −1/r twice where the
/// normal points outwards, 1/r where it points inwards.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Curvature {
    /// k1·k2, in 1/length²; it does not depend on the normal's side.
    pub gaussian: f64,
    /// (k1 + k2)/2, in 1/length.
    pub mean: f64,
    /// The greater principal curvature.
    pub k1: f64,
    /// The lesser principal curvature.
    pub k2: f64,
}

/// Where ∂u × ∂v vanishes: the step, as a share of the way to the patch's middle, of the samples that the limit is
/// extrapolated from. Its fourth power is what the extrapolation leaves out, its square what rounding is divided by:
/// both 1e-10 or so.
const LIMIT_STEP: f64 = 1.0 / 256.0;

/// A limit is believed when the nearest sample is within this share of it; that of a diverging 1/h is half of it.
const LIMIT_SHARE: f64 = 0.25;

/// … or within this much in units of 1/size, where all of it is noise about zero.
const LIMIT_NOISE: f64 = 1e-6;

impl Patch {
    /// The Gaussian, mean and principal curvatures at (u, v).
    ///
    /// From the first and second fundamental forms E, F, G and L, M, N: gaussian = (LN − M²)/(EG − F²),
    /// mean = (EN − 2FM + GL)/(2(EG − F²)), computed as the shape operator's matrix in an orthonormal frame, whose
    /// eigenvalues k1 ≥ k2 lose no digits. Units: 1/length, and 1/length² for the Gaussian.
    ///
    /// Where ∂u × ∂v vanishes, as at a collapsed side, they are the limits coming straight from the patch's middle,
    /// extrapolated to some 8 digits; zeros where there is no limit (the tip of a cone) and for a patch that is a curve
    /// or a point. Source: do Carmo, *Differential Geometry of Curves and Surfaces*, §3.3.
    pub fn curvature(&self, u: f64, v: f64) -> Curvature {
        let frame = Frame::around(self.control_bounds());
        let patch = frame.image(self);
        let [k1, k2] = patch
            .principal(u, v)
            .or_else(|| patch.principal_limit(u, v))
            .unwrap_or_default()
            .map(|k| k / frame.size);
        Curvature {
            gaussian: k1 * k2,
            mean: 0.5 * (k1 + k2),
            k1,
            k2,
        }
    }

    /// k1 and k2 where ∂u × ∂v does not vanish.
    fn principal(&self, u: f64, v: f64) -> Option<[f64; 2]> {
        if !self.is_regular(u, v) {
            return None;
        }
        let p = self.partials(u, v);
        let cross = p.u.cross(p.v);
        let normal = Point::normalize_or_zero(cross);
        // ∂u = a·e1 and ∂v = b·e1 + c·e2 with unit vectors at right angles.
        let a = Point::length(p.u);
        let (b, c) = (p.u.dot(p.v) / a, Point::length(cross) / a);
        let [l, m, n] = [p.uu, p.uv, p.vv].map(|d: DVec3| d.dot(normal));
        let w11 = l / (a * a);
        let w12 = (m - b * l / a) / (a * c);
        let w22 = (n - b / a * (2.0 * m - b * l / a)) / (c * c);
        let (mean, half) = (0.5 * (w11 + w22), (0.5 * (w11 - w22)).hypot(w12));
        let k = [mean + half, mean - half];
        k.iter().all(|k| k.is_finite()).then_some(k)
    }

    /// The same, extrapolated along the straight way from (½, ½).
    fn principal_limit(&self, u: f64, v: f64) -> Option<[f64; 2]> {
        let mut limit = [0.0; 2];
        let mut nearest = [0.0; 2];
        // The cubic through the values at 1, 2, 3 and 4 steps, at 0.
        for (steps, weight) in [(4.0, -1.0), (3.0, 4.0), (2.0, -6.0), (1.0, 4.0)] {
            let toward_middle = |t: f64| t + (0.5 - t) * (steps * LIMIT_STEP);
            nearest = self.principal(toward_middle(u), toward_middle(v))?;
            for (sum, k) in limit.iter_mut().zip(nearest) {
                *sum += weight * k;
            }
        }
        let close = |(a, b): (&f64, &f64)| (a - b).abs() <= LIMIT_SHARE * a.abs() + LIMIT_NOISE;
        // Each of the two is extrapolated, and where both are nearly equal rounding may exchange them.
        let [k1, k2] = limit;
        let ordered = [k1.max(k2), k1.min(k2)];
        limit.iter().zip(&nearest).all(close).then_some(ordered)
    }

    /// Whether ∂u × ∂v is more than noise.
    fn is_regular(&self, u: f64, v: f64) -> bool {
        let (du, dv) = directions(&self.points, self.columns);
        let along_u = crate::patch::net::evaluate_net(&du, self.columns - 1, u, v);
        let along_v = crate::patch::net::evaluate_net(&dv, self.columns, u, v);
        Point::length(along_u.cross(along_v)) > REGULAR_RATIO
    }
}
