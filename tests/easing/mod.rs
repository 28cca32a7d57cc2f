//! Timing functions: accuracy in double the precision of f64, monotonicity, values at and beyond the ends, no NaN.

#[cfg(not(target_family = "wasm"))]
mod css;

use crate::support::exact::{self, Double, exactly};
use crate::support::{Rng, real, refused};
use casteljau::Easing;
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// Handles from CSS, at the limits of their range, and close to handles for which dx/dt vanishes.
const KNOWN: [[f64; 4]; 16] = [
    [0.25, 0.1, 0.25, 1.0],
    [0.42, 0.0, 1.0, 1.0],
    [0.0, 0.0, 0.58, 1.0],
    [0.42, 0.0, 0.58, 1.0],
    [0.68, -0.55, 0.265, 1.55],
    [1.0, 0.0, 0.0, 1.0],
    [1.0, 1.0, 0.0, 0.0],
    [0.0, 1.0, 1.0, 0.0],
    [0.0, 0.0, 0.0, 1.0],
    [0.0, 1.0, 0.0, 1.0],
    [1.0, 0.0, 1.0, 0.0],
    [1.0, 0.0, 1.0, 1.0],
    [0.999_999_999, 0.1, 1e-9, 0.7],
    [1e-300, 0.5, 1e-310, 0.5],
    [1.0 - f64::EPSILON, 0.0, f64::EPSILON, 1.0],
    [1.0 / 3.0, 0.2, 2.0 / 3.0, 0.9],
];

fn cases() -> usize {
    crate::support::cases(20_000, 1_000_000)
}

fn easing([x1, y1, x2, y2]: [f64; 4]) -> Easing {
    Easing::new(x1, y1, x2, y2).expect("in range")
}

/// The x of a handle, often at a limit of its range.
fn abscissa(rng: &mut Rng) -> f64 {
    match rng.below(6) {
        0 => 0.0,
        1 => 1.0,
        2 => rng.magnitude(-320.0, 0.0),
        3 => 1.0 - rng.magnitude(-17.0, 0.0),
        _ => rng.unit(),
    }
}

/// An x between 0 and 1, often near an end or the middle.
fn location(rng: &mut Rng) -> f64 {
    let x = match rng.below(6) {
        0 => rng.magnitude(-320.0, 0.0),
        1 => 1.0 - rng.magnitude(-16.5, 0.0),
        2 => 0.5 + 0.25 * rng.signed() * rng.magnitude(-16.5, 0.0),
        3 => real(rng.below(1025)) / 1024.0,
        _ => rng.unit(),
    };
    x.clamp(5e-324, 1.0_f64.next_down())
}

fn cubic(a: f64, b: f64, t: Double) -> Double {
    let s = exactly(1.0) - t;
    let three = exactly(3.0);
    three * s * s * t * exactly(a) + three * s * t * t * exactly(b) + t * t * t
}

/// With y handles of exactly ⅓ and ⅔, y would be t itself; the difference is a cubic of the rounding errors of the
/// thirds.
fn parameter(x1: f64, x2: f64, x: f64) -> Double {
    let y = easing([x1, 1.0 / 3.0, x2, 2.0 / 3.0]).eval(x);
    let (t, three) = (exactly(y), exactly(3.0));
    let s = exactly(1.0) - t;
    let missing = |third: f64, n: f64| three * exactly(third) - exactly(n);
    let more = s * s * t * missing(1.0 / 3.0, 1.0) + s * t * t * missing(2.0 / 3.0, 2.0);
    t - more
}

#[test]
fn the_residual_does_not_pass_1e_15() {
    let mut rng = Rng(91);
    let mut worst = 0.0_f64;
    for case in 0..cases() {
        let [x1, _, x2, _] = if case < 16 * 200 {
            KNOWN[case % 16]
        } else {
            [abscissa(&mut rng), 0.0, abscissa(&mut rng), 0.0]
        };
        let x = location(&mut rng);
        let residual = (cubic(x1, x2, parameter(x1, x2, x)) - exactly(x)).hi.abs();
        worst = worst.max(residual);
        assert!(residual <= 1e-15, "({x1:e}, {x2:e}) at {x:e}: {residual:e}");
    }
    println!("worst residual {worst:e}");
}

/// t by bisection in double the precision of f64, to 100 bits below the leading bit of the bracket.
fn slow(x1: f64, x2: f64, x: f64) -> Double {
    let (mut low, mut high) = (exactly(0.0), exactly(1.0));
    let half = exactly(0.5);
    for _ in 0..160 {
        let middle = (low + high) * half;
        let off = cubic(x1, x2, middle) - exactly(x);
        let bound = if off.hi + off.lo > 0.0 {
            &mut high
        } else {
            &mut low
        };
        *bound = middle;
    }
    low
}

/// Not only the residual is small: y is accurate to its last digits, even where dx/dt vanishes.
#[test]
fn y_is_right() {
    let mut rng = Rng(92);
    let mut worst = 0.0_f64;
    for case in 0..cases() / 4 {
        let mut handles = if case < 16 * 20 {
            KNOWN[case % 16]
        } else {
            [abscissa(&mut rng), 0.0, abscissa(&mut rng), 0.0]
        };
        if case >= 16 * 20 {
            (handles[1], handles[3]) = (3.0 * rng.signed(), 3.0 * rng.signed());
        }
        let [x1, y1, x2, y2] = handles;
        let x = location(&mut rng);
        let reference = cubic(y1, y2, slow(x1, x2, x)).hi;
        let error = (easing(handles).eval(x) - reference).abs();
        // The largest y of the curve's control points.
        let size = y1.abs().max(y2.abs()).max(1.0);
        // Where x′ is small, t = root(x) magnifies the rounding error of the terms of x.
        let s = slow(x1, x2, x);
        let speed = (cubic(x1, x2, s + exactly(1e-8)) - cubic(x1, x2, s - exactly(1e-8))).hi / 2e-8;
        let max = 4e-16 * size + 6e-17 * size * (1.0 / speed.max(1e-6));
        worst = worst.max(error / max);
        assert!(error <= max, "{handles:?} at {x:e}: {error:e} > {max:e}");
    }
    println!("worst share {worst}");
}

#[test]
fn monotone_where_the_handles_are() {
    let mut rng = Rng(93);
    for case in 0..cases() / 100 {
        let [x1, x2] = [abscissa(&mut rng), abscissa(&mut rng)];
        let mut y = [abscissa(&mut rng), abscissa(&mut rng)];
        y.sort_by(f64::total_cmp);
        let ease = easing([x1, y[0], x2, y[1]]);
        let mut xs: Vec<f64> = (0..50).map(|_| location(&mut rng)).collect();
        // Adjacent numbers as well.
        for at in [0.5, location(&mut rng), location(&mut rng)] {
            let mut x = at;
            for _ in 0..50 {
                xs.push(x);
                x = x.next_up().min(1.0);
            }
        }
        xs.sort_by(f64::total_cmp);
        let ys: Vec<f64> = xs.iter().map(|&x| ease.eval(x)).collect();
        for (x, pair) in xs.windows(2).zip(ys.windows(2)) {
            let ascending = (0.0..=1.0).contains(&pair[0]) && pair[0] <= pair[1];
            assert!(ascending, "case {case}, {ease:?}: {pair:?} at {x:?}");
        }
    }
}

#[test]
fn exact_at_the_ends() {
    for handles in KNOWN {
        let ends = [0.0, -0.0, 1.0].map(|x| easing(handles).eval(x));
        assert_eq!(ends, [0.0, 0.0, 1.0]);
    }
}

/// As defined in CSS Easing Functions Level 1.
#[test]
fn beyond_the_ends_along_the_tangents() {
    for (handles, x, y) in [
        ([0.25, 0.5, 0.5, 0.5], -1.0, -2.0),
        ([0.25, 0.5, 0.5, 0.5], 2.0, 2.0),
        // If the nearer handle has the x of the end: towards the other handle if the nearer one also has the y of the
        // end; otherwise constant.
        ([0.0, 0.0, 0.5, 1.0], -1.0, -2.0),
        ([0.0, 0.5, 0.5, 1.0], -1.0, 0.0),
        ([0.5, 0.0, 1.0, 1.0], 2.0, 3.0),
        ([0.5, 0.0, 1.0, 0.5], 2.0, 1.0),
        // If both handles coincide with the end: the diagonal.
        ([0.0, 0.0, 0.0, 0.0], -3.0, -3.0),
        ([1.0, 1.0, 1.0, 1.0], 3.0, 3.0),
        ([0.0, 0.0, 0.0, 1.0], -3.0, 0.0),
    ] {
        assert_eq!(easing(handles).eval(x), y, "{handles:?} at {x}");
    }
}

#[test]
fn the_diagonal_is_exact() {
    let mut rng = Rng(94);
    for _ in 0..1000 {
        let (a, b) = (abscissa(&mut rng), abscissa(&mut rng));
        let x = location(&mut rng);
        assert_eq!(easing([a, a, b, b]).eval(x), x);
    }
}

#[test]
fn never_nan_nor_infinite() {
    const MAX: f64 = f64::MAX;
    let xs = [0.0, -0.0, 1.0, 0.5, 5e-324, 1e-300];
    let ys = [
        0.0, -0.0, 1.0, 0.5, 5e-324, -5e-324, 1e-300, 1e300, MAX, -MAX,
    ];
    let inside = [0.0, 5e-324, 1e-300, 1e-9, 0.5, 1.0_f64.next_down(), 1.0];
    let outside = [2.0, -2.0, MAX, -MAX, -5e-324];
    for [x1, x2] in xs.iter().flat_map(|&a| xs.map(|b| [a, b])) {
        for [y1, y2] in ys.iter().flat_map(|&a| ys.map(|b| [a, b])) {
            let ease = easing([x1, y1, x2, y2]);
            for x in inside.into_iter().chain(outside) {
                assert!(ease.eval(x).is_finite(), "{ease:?} at {x:e}");
            }
        }
    }
}

/// js/geometry/easing.ts must give the same bits: tests/js/easing.test.js has the same cases and the same sum.
#[test]
fn the_same_bits_as_in_javascript() {
    let mut rng = Rng(95);
    let mut sum = 0_u64;
    for _ in 0..500 {
        let mut handle = || [rng.unit(), 3.0 * rng.signed()];
        let ([x1, y1], [x2, y2]) = (handle(), handle());
        let ease = easing([x1, y1, x2, y2]);
        for _ in 0..8 {
            sum = sum.rotate_left(7) ^ ease.eval(1.5 * rng.unit() - 0.25).to_bits();
        }
    }
    for handles in KNOWN {
        let ease = easing(handles);
        for k in 0..64 {
            sum = sum.rotate_left(7) ^ ease.eval(real(k) / 63.0).to_bits();
        }
    }
    assert_eq!(sum, 0x5611_b466_7573_a859, "{sum:#x}");
}

#[test]
fn refusals() {
    let infinities = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    for (k, what) in ["x1", "y1", "x2", "y2"].into_iter().enumerate() {
        let outside = [-0.1, 1.1, -5e-324];
        let outside = if k % 2 == 0 { &outside[..] } else { &[] };
        for &value in outside.iter().chain(&infinities) {
            let mut handles = [0.5; 4];
            handles[k] = value;
            let [x1, y1, x2, y2] = handles;
            refused(Easing::new(x1, y1, x2, y2), &format!("Range {what}"));
        }
    }
}

/// A compensated sum, compared with a value known in closed form.
#[test]
fn the_middle_of_the_steepest() {
    // x = ½ + 4(t − ½)³ and y = ½ + 1.5(t − ½) − 2(t − ½)³: at x = ½ + 4·2⁻⁴⁸ t is ½ + 2⁻¹⁶.
    let off = 2.0_f64.powi(-16);
    let y = easing([1.0, 0.0, 0.0, 1.0]).eval(0.5 + 4.0 * off * off * off);
    assert_eq!(y, exact::sum(&[0.5, 1.5 * off, -2.0 * off * off * off]));
}
