//! Classification of curves: curves are constructed for each kind, then moved, stretched, elevated and put into space.

use crate::points::cases;
use crate::support::adversarial::{self, elevated};
use crate::support::{Rng, bezier, curve, xyz};
use casteljau::curve::CurveKind;
use casteljau::glam::{DVec2, DVec3};

/// A cubic of a kind. Cubics with crossed handles (0,0) (k,1) (1−k,1) (1,0) have the discriminant (1 − k)(3k − 1).
fn result(rng: &mut Rng, class: CurveKind) -> Vec<DVec3> {
    let between = |rng: &mut Rng, low: f64, high: f64| low + (high - low) * rng.unit();
    let crossed = |k: f64| [(0.0, 0.0), (k, 1.0), (1.0 - k, 1.0), (1.0, 0.0)];
    let points = match class {
        CurveKind::Point => [(0.5, 0.25); 4],
        CurveKind::Line => [(); 4].map(|()| rng.signed()).map(|x| (x, 0.0)),
        CurveKind::Arch => crossed(between(rng, 0.05, 0.48)),
        CurveKind::Serpentine if rng.chance(0.5) => crossed(between(rng, 0.52, 0.97)),
        CurveKind::Serpentine => {
            let (up, down) = (between(rng, 0.1, 2.0), between(rng, -2.0, -0.1));
            [(0.0, 0.0), (1.0, up), (2.0, down), (3.0, 0.0)]
        }
        CurveKind::Cusp => crossed(1.0),
        CurveKind::Loop => crossed(between(rng, 1.03, 4.0)),
        CurveKind::Quadratic | CurveKind::Twisted => {
            [(0.0, 0.0), (1.0, 3.0), (2.0, 1.0), (0.0, 0.0)]
        }
    };
    let mut points: Vec<DVec3> = points.iter().map(|&(x, y)| DVec3::new(x, y, 0.0)).collect();
    if class == CurveKind::Quadratic {
        points.truncate(3);
    }
    if class == CurveKind::Twisted {
        points[3].z = between(rng, 0.1, 1.0);
    }
    points
}

const CLASSES: [CurveKind; 8] = [
    CurveKind::Point,
    CurveKind::Line,
    CurveKind::Quadratic,
    CurveKind::Arch,
    CurveKind::Serpentine,
    CurveKind::Loop,
    CurveKind::Cusp,
    CurveKind::Twisted,
];

#[test]
fn the_class_stays_under_affine_maps() {
    let mut rng = Rng(110);
    for case in 0..cases() {
        let class = CLASSES[case % CLASSES.len()];
        let mut points = result(&mut rng, class);
        // Loops and inflections of higher degrees are different, so only a few elevations.
        for _ in 0..rng.below(3) {
            points = elevated(&points);
        }
        let twisted = class == CurveKind::Twisted;
        let dimension = if twisted {
            3
        } else {
            2 + case / CLASSES.len() % 2
        };
        let (a, b, c) = (rng.point(dimension), rng.point(dimension), rng.point(3));
        let across = a.cross(b);
        let spread = if dimension == 2 {
            across.z
        } else {
            across.dot(c)
        }
        .abs();
        if spread < 0.05 {
            continue;
        }
        let offset = rng.point(dimension) * rng.pick(&[0.0, 1.0, 1e3]);
        let scale = rng.pick(&[1.0, 1e9, 1e-9, 1e140, 1e-200]);
        let map = |p: &DVec3| (a * p.x + b * p.y + c * p.z + offset) * scale;
        let image: Vec<DVec3> = points.iter().map(map).collect();
        if dimension == 2 {
            assert_eq!(curve::<DVec2>(&image).classify(), class, "{image:?}");
        } else {
            assert_eq!(curve::<DVec3>(&image).classify(), class, "{image:?}");
        }
        let back: Vec<DVec3> = image.into_iter().rev().collect();
        assert_eq!(curve::<DVec3>(&back).classify(), class, "{back:?}");
        if class == CurveKind::Cusp {
            let ts = curve::<DVec3>(&back).cusps();
            let middle = ts.len() == 1 && (ts[0] - 0.5).abs() < 1e-6;
            assert!(middle, "{ts:?} {back:?}");
        }
    }
}

#[test]
fn every_curve_has_a_class() {
    let mut rng = Rng(111);
    for &kind in &adversarial::ALL {
        for degree in [1, 2, 3, 4, 5, 9, 33, 64] {
            for dimension in [2, 3] {
                let points = adversarial::points(&mut rng, kind, degree, dimension);
                let class = curve::<DVec3>(&points).classify();
                if dimension == 2 {
                    assert_eq!(curve::<DVec2>(&points).classify(), class, "{points:?}");
                    assert_ne!(class, CurveKind::Twisted);
                }
            }
        }
    }
}

#[test]
fn features_count_only_inside() {
    use CurveKind::{Arch, Line, Loop, Serpentine};
    for (points, [t0, t1], class) in [
        // The inflection at t = 0 of a zero-length handle, a double point beyond the end, a cusp at the start.
        ("0 0, 0 0, 1 1, 2 0", [0.0, 1.0], Arch),
        ("0 0, 4 2, -2 2, 2 0", [0.0, 1.0], Loop),
        ("0 0, 4 2, -2 2, 2 0", [0.0, 0.5], Arch),
        ("0 0, 3 2, -3 2, 0 0", [0.0, 1.0], Loop),
        ("0 0, 1 1, 0 1, 1 0", [0.0, 0.5], Arch),
        ("0 0, 1 1, 0 1, 1 0", [0.5, 1.0], Arch),
        // Degree 4: a loop, and a wave with more inflections than a cubic has.
        ("0 0, 4 1, 1 3, -2 1, 2 0", [0.0, 1.0], Loop),
        ("0 0, 1 2, 2 -3, 3 2, 4 0", [0.0, 1.0], Serpentine),
        ("0 0, 0 1, 1 2, 2 1, 2 0", [0.0, 1.0], Arch),
        ("0 0, 2 2, 1 1", [0.0, 1.0], Line),
    ] {
        let part = bezier(points).subsegment(t0..t1);
        assert_eq!(part.classify(), class, "{points} from {t0} to {t1}");
    }
    assert!(bezier("0 0, 1 1, 0 1, 1 0").inflections().is_empty());
    assert_eq!(bezier("0 0, 2 2, 1 1").cusps().len(), 1);
    // Lines in oblique directions.
    for ends in ["1 2 -2, -2 -2 1", "2 2 -2, -2 -1 1"] {
        assert_eq!(curve::<DVec3>(&xyz(ends)).classify(), Line, "{ends}");
    }
}
