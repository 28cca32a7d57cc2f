//! Classification of curves: curves are constructed for each kind, then moved, stretched, elevated and put into space.

use crate::points::cases;
use crate::support::adversarial::{self, elevated};
use crate::support::{Rng, curve, plane};
use casteljau::Curve;
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
        CurveKind::Serpentine => [
            (0.0, 0.0),
            (1.0, between(rng, 0.1, 2.0)),
            (2.0, between(rng, -2.0, -0.1)),
            (3.0, 0.0),
        ],
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
        let dimension = if class == CurveKind::Twisted {
            3
        } else {
            2 + case / CLASSES.len() % 2
        };
        let (a, b, c) = (rng.point(dimension), rng.point(dimension), rng.point(3));
        let spread = if dimension == 2 {
            a.cross(b).z.abs()
        } else {
            a.cross(b).dot(c).abs()
        };
        if spread < 0.05 {
            continue;
        }
        let offset = rng.point(dimension) * rng.pick(&[0.0, 1.0, 1e3]);
        let scale = rng.pick(&[1.0, 1e9, 1e-9, 1e140, 1e-200]);
        let image: Vec<DVec3> = points
            .iter()
            .map(|p| (a * p.x + b * p.y + c * p.z + offset) * scale)
            .collect();
        let found = if dimension == 2 {
            curve::<DVec2>(&image).classify()
        } else {
            curve::<DVec3>(&image).classify()
        };
        assert_eq!(found, class, "{image:?}");
        let back: Vec<DVec3> = image.into_iter().rev().collect();
        assert_eq!(curve::<DVec3>(&back).classify(), class, "{back:?}");
        if class == CurveKind::Cusp {
            let ts = curve::<DVec3>(&back).cusps();
            assert!(
                ts.len() == 1 && (ts[0] - 0.5).abs() < 1e-6,
                "{ts:?} {back:?}"
            );
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
    // The inflection at t = 0 of a zero-length handle, a double point beyond the end, a cusp at the start.
    assert_eq!(
        plane(&[(0.0, 0.0), (0.0, 0.0), (1.0, 1.0), (2.0, 0.0)]).classify(),
        CurveKind::Arch
    );
    let whole = plane(&[(0.0, 0.0), (4.0, 2.0), (-2.0, 2.0), (2.0, 0.0)]);
    assert_eq!(whole.classify(), CurveKind::Loop);
    assert_eq!(whole.subsegment(0.0, 0.5).classify(), CurveKind::Arch);
    assert_eq!(
        plane(&[(0.0, 0.0), (3.0, 2.0), (-3.0, 2.0), (0.0, 0.0)]).classify(),
        CurveKind::Loop
    );
    let cusp = plane(&[(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)]);
    assert_eq!(cusp.subsegment(0.0, 0.5).classify(), CurveKind::Arch);
    assert_eq!(cusp.subsegment(0.5, 1.0).classify(), CurveKind::Arch);
    assert!(cusp.inflections().is_empty());
    // Degree 4: a loop, and a wave with more inflections than a cubic has.
    assert_eq!(
        plane(&[(0.0, 0.0), (4.0, 1.0), (1.0, 3.0), (-2.0, 1.0), (2.0, 0.0)]).classify(),
        CurveKind::Loop
    );
    assert_eq!(
        plane(&[(0.0, 0.0), (1.0, 2.0), (2.0, -3.0), (3.0, 2.0), (4.0, 0.0)]).classify(),
        CurveKind::Serpentine
    );
    assert_eq!(
        plane(&[(0.0, 0.0), (0.0, 1.0), (1.0, 2.0), (2.0, 1.0), (2.0, 0.0)]).classify(),
        CurveKind::Arch
    );
    let turning: Curve<DVec2> = plane(&[(0.0, 0.0), (2.0, 2.0), (1.0, 1.0)]);
    assert_eq!(
        (turning.classify(), turning.cusps().len()),
        (CurveKind::Line, 1)
    );
}

#[test]
fn lines_in_oblique_directions_are_lines() {
    let ends = [
        [(1.0, 2.0, -2.0), (-2.0, -2.0, 1.0)],
        [(2.0, 2.0, -2.0), (-2.0, -1.0, 1.0)],
    ];
    for ends in ends {
        let points = ends.map(DVec3::from);
        assert_eq!(curve::<DVec3>(&points).classify(), CurveKind::Line);
    }
}
