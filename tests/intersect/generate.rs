//! Pairs of curves, most of them degenerate.

use crate::support::{Rng, random_points, real};
use casteljau::Curve;
use casteljau::glam::DVec2;

pub(crate) struct Case {
    pub(crate) name: &'static str,
    pub(crate) a: Curve<DVec2>,
    pub(crate) b: Curve<DVec2>,
}

pub(crate) fn new(points: &[DVec2]) -> Curve<DVec2> {
    Curve::new(points).expect("finite points")
}

fn free(rng: &mut Rng, degree: usize) -> Vec<DVec2> {
    random_points(rng, degree + 1)
}

/// Points of a small grid, so that coincidences are exact.
fn grid(rng: &mut Rng, degree: usize, size: usize) -> Vec<DVec2> {
    let mut coordinate = || real(rng.below(size + 1));
    (0..=degree)
        .map(|_| DVec2::new(coordinate(), coordinate()))
        .collect()
}

fn low_degree(rng: &mut Rng) -> usize {
    rng.pick(&[1, 2, 2, 3, 3, 3, 3, 3, 4, 5])
}

/// A cubic with a given point and derivative at ½.
fn through_middle(rng: &mut Rng, point: DVec2, derivative: DVec2) -> Vec<DVec2> {
    let inner = grid(rng, 1, 4);
    let sum = point * 8.0 - (inner[0] + inner[1]) * 3.0;
    let difference = derivative * (4.0 / 3.0) - (inner[1] - inner[0]);
    let (first, last) = ((sum - difference) * 0.5, (sum + difference) * 0.5);
    vec![first, inner[0], inner[1], last]
}

/// The graph of a polynomial with these Bernstein coefficients over [0, 1].
pub(crate) fn graph(rows: &[f64]) -> Vec<DVec2> {
    let n = real(rows.len() - 1);
    let point = |(i, &y): (usize, &f64)| DVec2::new(real(i) / n, y);
    rows.iter().enumerate().map(point).collect()
}

/// (x − r)ᵏ in Bernstein form of degree k: exact for a dyadic r.
fn power(k: i32, r: f64) -> Vec<f64> {
    let term = |j: i32| (-r).powi(k - j) * (1.0 - r).powi(j);
    (0..=k).map(term).collect()
}

/// Two graphs whose difference is c (x − r)ᵏ.
fn touching_graphs(rng: &mut Rng) -> (Vec<DVec2>, Vec<DVec2>) {
    let k = rng.pick(&[2, 3, 4, 5]);
    let r = rng.pick(&[0.0, 0.25, 0.5, 0.75, 1.0]);
    let c = rng.pick(&[-2.0, -1.0, 0.5, 1.0, 4.0]);
    let base: Vec<f64> = (0..=k).map(|_| real(rng.below(9)) * 0.25).collect();
    let other = base.iter().zip(power(k, r)).map(|(y, p)| y + c * p);
    (graph(&base), graph(&other.collect::<Vec<_>>()))
}

fn straight(rng: &mut Rng) -> Vec<DVec2> {
    let degree = rng.pick(&[1, 2, 3, 3]);
    let mut point = || DVec2::new(1.0, 2.0) * real(rng.below(9));
    (0..=degree).map(|_| point()).collect()
}

fn cusp(rng: &mut Rng) -> Vec<DVec2> {
    let (x, y) = (real(1 + rng.below(4)), real(1 + rng.below(4)));
    let handles = (DVec2::new(x, y), DVec2::new(0.0, y));
    vec![DVec2::ZERO, handles.0, handles.1, DVec2::new(x, 0.0)]
}

fn shapes(rng: &mut Rng) -> (&'static str, Curve<DVec2>, Curve<DVec2>) {
    let (n, m) = (low_degree(rng), low_degree(rng));
    let on_grid = rng.chance(0.5);
    let a = new(&if on_grid {
        grid(rng, n, 4)
    } else {
        free(rng, n)
    });
    let dyadic = [0.0, 0.25, 0.5, 0.75, 1.0];
    match rng.below(14) {
        0 => ("free", new(&free(rng, n)), new(&free(rng, m))),
        1 => ("grid", new(&grid(rng, n, 4)), new(&grid(rng, m, 4))),
        2 => ("small grid", new(&grid(rng, n, 2)), new(&grid(rng, m, 2))),
        3 => {
            let mut b = grid(rng, m, 4);
            b[0] = if rng.chance(0.5) { a.start() } else { a.end() };
            if rng.chance(0.3) {
                b[m] = a.start();
            }
            ("shared ends", a, new(&b))
        }
        4 => {
            let a = new(&grid(rng, 3, 4));
            let (p, d) = (a.eval(0.5), a.derivative_at(0.5, 1));
            let along = d * rng.pick(&[1.0, -1.0, 2.0, 0.5]);
            let b = new(&through_middle(rng, p, along));
            ("tangent amid", a, b)
        }
        5 => {
            let t = rng.pick(&dyadic);
            let (p, d) = (a.eval(t), a.derivative_at(t, 1));
            let mut b = grid(rng, m, 4);
            b[0] = p;
            b[1] = p + d * rng.pick(&[-1.0, 1.0, 0.5]);
            ("tangent at an end", a, new(&b))
        }
        6 => {
            let (a, b) = touching_graphs(rng);
            ("order", new(&a), new(&b))
        }
        7 => {
            let (t0, t1) = (rng.pick(&dyadic), rng.pick(&dyadic));
            ("subsegment", a.clone(), a.subsegment(t0..t1))
        }
        8 => {
            let b = a.subsegment(rng.pick(&[0.0, 0.25])..rng.pick(&[0.5, 1.0]));
            ("elevated", a, b.elevate().expect("low").reverse())
        }
        kind => special_shapes(rng, kind, a, m),
    }
}

fn special_shapes(
    rng: &mut Rng,
    kind: usize,
    a: Curve<DVec2>,
    m: usize,
) -> (&'static str, Curve<DVec2>, Curve<DVec2>) {
    let dyadic = [0.0, 0.25, 0.5, 0.75, 1.0];
    match kind {
        9 => ("straight", new(&straight(rng)), new(&straight(rng))),
        10 => ("straight", new(&straight(rng)), a),
        11 => {
            let cusp = new(&cusp(rng));
            let p = cusp.eval(0.5);
            let mut b = grid(rng, m, 4);
            if rng.chance(0.5) {
                b = b.iter().map(|q| *q - b[0] * 0.5 - b[m] * 0.5 + p).collect();
            }
            ("cusp", cusp, new(&b))
        }
        12 => {
            let p = a.eval(rng.pick(&dyadic));
            ("point", a, new(&[p, p, p]))
        }
        _ => {
            let shift = DVec2::new(rng.signed(), rng.signed()) * rng.magnitude(-12.0, -3.0);
            let b: Vec<DVec2> = a.control_points().iter().map(|p| *p + shift).collect();
            ("shifted", a, new(&b))
        }
    }
}

pub(crate) fn case(rng: &mut Rng) -> Case {
    let (name, a, b) = shapes(rng);
    let (scale, shift) = match rng.below(8) {
        0 => (1e-9, DVec2::ZERO),
        1 => (1e9, DVec2::ZERO),
        2 => (1.0, DVec2::new(1e6, -3e6)),
        _ => (1.0, DVec2::ZERO),
    };
    let location = |c: &Curve<DVec2>| {
        let points = c.control_points().iter().map(|p| *p * scale + shift);
        new(&points.collect::<Vec<_>>())
    };
    let (a, b) = if rng.chance(0.5) { (a, b) } else { (b, a) };
    Case {
        name,
        a: location(&a),
        b: location(&b),
    }
}
