//! What is a zone of contact?

use super::super::{Points, evaluate};
use super::Contact;
use super::pair::Pair;
use super::zone::Zone;
use crate::point::Point;
use glam::DVec2;

/// Newton's method halves the distance from a contact of higher order with each step.
const TANGENCY_STEPS: usize = 50;

/// The point and the first two derivatives.
pub(super) fn taylor(points: &[DVec2], t: f64) -> [DVec2; 3] {
    let n = (points.len() - 1) as f64;
    let slopes: Points<DVec2> = points.windows(2).map(|p| p[1] - p[0]).collect();
    let bends: Points<DVec2> = slopes.windows(2).map(|p| p[1] - p[0]).collect();
    let bend = if bends.is_empty() {
        DVec2::ZERO
    } else {
        evaluate(&bends, t)
    };
    [
        evaluate(points, t),
        evaluate(&slopes, t) * n,
        bend * (n * (n - 1.0)),
    ]
}

impl Pair {
    /// The distance of A(t) from the tangent of B at u, with a sign.
    pub(super) fn height(&self, t: f64, u: f64) -> f64 {
        let [a, da, _] = taylor(&self.a, t);
        let [b, db, _] = taylor(&self.b, u);
        let direction = if db == DVec2::ZERO { da } else { db };
        let along = direction.normalize_or_zero();
        if along == DVec2::ZERO {
            (a - b).length()
        } else {
            along.perp_dot(a - b)
        }
    }

    /// The parameter on B that is nearest to A(t), from u on.
    fn opposite(&self, t: f64, mut u: f64) -> f64 {
        let a = evaluate(&self.a, t);
        for _ in 0..8 {
            let [b, db, _] = taylor(&self.b, u);
            let step = (a - b).dot(db) / db.length_squared();
            if !step.is_finite() {
                break;
            }
            u = (u + step).clamp(0.0, 1.0);
        }
        u
    }

    fn apart(&self, t: f64, u: f64) -> f64 {
        (evaluate(&self.a, t) - evaluate(&self.b, u)).max_abs()
    }

    /// Says what a zone is.
    pub(super) fn settle(&self, zone: &Zone, places: &mut Vec<(f64, f64, Contact)>) {
        if zone.crossing {
            let (t, u) = zone.ends()[0];
            let t = snapped(&self.a, t, self.slack);
            let u = snapped(&self.b, u, self.slack);
            return places.push((t, u, Contact::Cross));
        }
        if let Some(overlap) = self.overlap(zone) {
            return places.push(overlap);
        }
        if let Some((t, u)) = self.end_in(zone) {
            return places.push((t, u, self.kind(t, u)));
        }
        let middle = (0.5 * (zone.t[0] + zone.t[1]), 0.5 * (zone.u[0] + zone.u[1]));
        let close =
            |&(t, u): &(f64, f64)| zone.holds((t, u)) && self.height(t, u).abs() <= self.slack;
        if let Some((t, u)) = self.tangency(middle).filter(close) {
            return places.push((t, u, Contact::Tangent));
        }
        let [start, end] = zone
            .ends()
            .map(|place| self.crossing(place).filter(|&place| zone.holds(place)));
        let same = |p: (f64, f64), q: (f64, f64)| (p.0 - q.0).abs() + (p.1 - q.1).abs() < 1e-10;
        match (start, end) {
            (Some(p), Some(q)) if !same(p, q) => {
                places.extend([(p.0, p.1, Contact::Cross), (q.0, q.1, Contact::Cross)])
            }
            (Some((t, u)), _) | (None, Some((t, u))) => places.push((t, u, self.kind(t, u))),
            // A contact of higher order, or a cusp.
            (None, None) => self.blunt(middle, places),
        }
    }

    /// A contact that Newton's method does not sharpen.
    fn blunt(&self, (t, u): (f64, f64), places: &mut Vec<(f64, f64, Contact)>) {
        let u = self.opposite(t, u);
        if self.height(t, u).abs() <= 2.0 * self.slack {
            places.push((t, u, self.kind(t, u)));
        }
    }

    /// The crossing that Newton's method finds from here.
    fn crossing(&self, (mut t, mut u): (f64, f64)) -> Option<(f64, f64)> {
        for _ in 0..20 {
            let [a, da, _] = taylor(&self.a, t);
            let [b, db, _] = taylor(&self.b, u);
            let turn = da.perp_dot(db);
            let (dt, du) = ((b - a).perp_dot(db) / turn, (b - a).perp_dot(da) / turn);
            if !(dt.is_finite() && du.is_finite()) {
                return (a == b).then_some((t, u));
            }
            (t, u) = ((t + dt).clamp(0.0, 1.0), (u + du).clamp(0.0, 1.0));
            if dt.abs() + du.abs() < 1e-14 {
                break;
            }
        }
        (self.apart(t, u) <= 2.0 * self.slack).then_some((t, u))
    }

    /// The ends of a zone; of one too small to know its direction, as they are closer together.
    fn paired(&self, zone: &Zone) -> [(f64, f64); 2] {
        let ends = zone.ends();
        let crossed = [(ends[0].0, ends[1].1), (ends[1].0, ends[0].1)];
        let apart = |ends: [(f64, f64); 2]| ends.map(|(t, u)| self.apart(t, u)).iter().sum::<f64>();
        if zone.direction == 0.0 && apart(crossed) < apart(ends) {
            crossed
        } else {
            ends
        }
    }

    fn overlap(&self, zone: &Zone) -> Option<(f64, f64, Contact)> {
        let [(t, u), (t_end, u_end)] = self.paired(zone);
        let length = (evaluate(&self.a, t) - evaluate(&self.a, t_end)).max_abs();
        let outer = |t: f64, u: f64| is_end(t) || is_end(u);
        (length > 64.0 * self.slack && outer(t, u) && outer(t_end, u_end)).then_some((
            t,
            u,
            Contact::Overlap { t_end, u_end },
        ))
    }

    /// A place of the zone where a curve ends: both if there is one.
    fn end_in(&self, zone: &Zone) -> Option<(f64, f64)> {
        let [t0, t1] = zone.t;
        let [u0, u1] = zone.u;
        let ts = [(t0 == 0.0).then_some(0.0), (t1 == 1.0).then_some(1.0)];
        let us = [(u0 == 0.0).then_some(0.0), (u1 == 1.0).then_some(1.0)];
        let close = |t: f64, u: f64| (self.apart(t, u) <= 2.0 * self.slack).then_some((t, u));
        for t in ts.into_iter().flatten() {
            for u in us.into_iter().flatten() {
                if let Some(place) = close(t, u) {
                    return Some(place);
                }
            }
        }
        let (mid_t, mid_u) = (0.5 * (t0 + t1), 0.5 * (u0 + u1));
        for t in ts.into_iter().flatten() {
            if let Some(place) = close(t, self.opposite(t, mid_u)) {
                return Some(place);
            }
        }
        let swapped = Self {
            a: self.b.clone(),
            b: self.a.clone(),
            slack: self.slack,
        };
        us.into_iter()
            .flatten()
            .find_map(|u| close(swapped.opposite(u, mid_t), u))
    }

    /// Where both have the same direction and are nearest to each other: A′ × B′ = 0 and (A − B) · A′ = 0.
    fn tangency(&self, (mut t, mut u): (f64, f64)) -> Option<(f64, f64)> {
        for _ in 0..TANGENCY_STEPS {
            let [a, da, dda] = taylor(&self.a, t);
            let [b, db, ddb] = taylor(&self.b, u);
            let turn = da.perp_dot(db);
            let ahead = (a - b).dot(da);
            let (m00, m01) = (dda.perp_dot(db), da.perp_dot(ddb));
            let (m10, m11) = (da.dot(da) + (a - b).dot(dda), -db.dot(da));
            let det = m00 * m11 - m01 * m10;
            let (dt, du) = (
                (turn * m11 - ahead * m01) / det,
                (m00 * ahead - m10 * turn) / det,
            );
            if !(dt.is_finite() && du.is_finite()) {
                break;
            }
            (t, u) = (t - dt, u - du);
            if dt.abs() + du.abs() < 1e-14 {
                break;
            }
        }
        ((0.0..=1.0).contains(&t) && (0.0..=1.0).contains(&u)).then_some((t, u))
    }

    /// Tangent where the directions differ by no more than rounding can turn them.
    fn kind(&self, t: f64, u: f64) -> Contact {
        let a = Curve::from_slice(&self.a).tangent(t);
        let b = Curve::from_slice(&self.b).tangent(u);
        let [_, da, _] = taylor(&self.a, t);
        let [_, db, _] = taylor(&self.b, u);
        let turned = 16.0 * self.slack * (1.0 / da.length() + 1.0 / db.length());
        if a.perp_dot(b).abs() <= turned.min(1e-6) && a != DVec2::ZERO && b != DVec2::ZERO {
            Contact::Tangent
        } else {
            Contact::Cross
        }
    }
}

use super::Curve;

fn is_end(t: f64) -> bool {
    t == 0.0 || t == 1.0
}

/// A parameter that is an end but for rounding is the end.
fn snapped(points: &[DVec2], t: f64, slack: f64) -> f64 {
    let end = t.round();
    if t == end || (t - end).abs() > 1e-6 {
        return t;
    }
    let apart = (evaluate(points, t) - evaluate(points, end)).max_abs();
    if apart <= slack { end } else { t }
}
