//! Conics as arcs of ellipses, SVG path data, JSON, and kurbo's arcs.

use super::within;
use crate::support::Rng;
use casteljau::glam::{DAffine2, DVec2, DVec3};
use casteljau::{NurbsCurve, NurbsSurface, Path, RationalCurve, RationalPatch};

fn quarter() -> RationalCurve<DVec2> {
    let points = [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from);
    RationalCurve::new(&points, &[1.0, 0.5_f64.sqrt(), 1.0]).expect("valid")
}

#[test]
fn conics_are_arcs_of_ellipses() {
    let mut rng = Rng(21);
    for round in 0..500 {
        let points = [(); 3].map(|()| DVec2::new(rng.signed(), rng.signed()));
        let weights = [(); 3].map(|()| within(&mut rng, -2.0, 2.0).exp2());
        let conic = RationalCurve::new(&points, &weights).expect("valid");
        let [w0, w1, w2] = weights;
        let Some(arc) = conic.to_elliptical_arc() else {
            assert!(w1 * w1 >= w0 * w2, "{round}");
            continue;
        };
        let axes = DAffine2::from_scale_angle_translation(arc.radii, arc.rotation, arc.center);
        let size = arc.radii.max_element();
        for k in 0..=10 {
            let angle = arc.start_angle + arc.sweep_angle * f64::from(k) / 10.0;
            let p = axes.transform_point2(DVec2::from_angle(angle));
            let off = conic.nearest(p).expect("finite").distance;
            assert!(off <= 1e-12 * size.max(1.0), "{round}: {off:e} {arc:?}");
        }
        let ends = [arc.start_angle, arc.start_angle + arc.sweep_angle];
        let ends = ends.map(|angle| axes.transform_point2(DVec2::from_angle(angle)));
        assert!((ends[0] - conic.start()).length() <= 1e-12 * size.max(1.0));
        assert!((ends[1] - conic.end()).length() <= 1e-12 * size.max(1.0));
        let theirs = kurbo::Arc::try_from(&conic).expect("an arc");
        let again = NurbsCurve::try_from(theirs).expect("finite");
        assert!((again.end() - conic.end()).length() <= 1e-12 * size.max(1.0));
    }
    let arc = quarter().to_elliptical_arc().expect("a circle");
    assert!(arc.center.length() < 1e-15 && (arc.radii - DVec2::ONE).length() < 1e-15);
    assert_eq!(arc.rotation, 0.0);
    let line = [(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)].map(DVec2::from);
    let straight = RationalCurve::new(&line, &[1.0, 0.5, 1.0]).expect("valid");
    assert_eq!(straight.to_elliptical_arc(), None);
}

#[test]
fn svg_path_data_has_arcs() {
    let circle = NurbsCurve::circle(DVec2::new(1.0, 2.0), 0.5).expect("finite");
    assert_eq!(
        circle.to_svg(1e-3).expect("a tolerance"),
        "M1.5,2 A0.5,0.5 0 0 1 1,2.5 A0.5,0.5 0 0 1 0.5,2 A0.5,0.5 0 0 1 1,1.5 A0.5,0.5 0 0 1 1.5,2 Z"
    );
    // Rounding leaves no traces in the text.
    let slanted = NurbsCurve::ellipse(DVec2::new(0.1, 0.7), DVec2::new(0.3, 0.2), 0.3);
    let text = slanted.expect("finite").to_svg(1e-3).expect("a tolerance");
    let arcs: Vec<&str> = text.split(" A").skip(1).collect();
    assert_eq!(arcs.len(), 4);
    let degrees = 0.3_f64.to_degrees();
    for arc in arcs {
        assert!(
            arc.starts_with(&format!("0.3,0.2 {degrees:.13} 0 1 ")),
            "{arc}"
        );
    }
    let mut rng = Rng(22);
    for _ in 0..100 {
        let points = [(); 3].map(|()| DVec2::new(rng.signed(), rng.signed()));
        let conic = RationalCurve::conic(points[0], points[1], points[2], rng.unit() + 0.01);
        let conic = conic.expect("valid");
        let path = Path::from_svg(&conic.to_svg(1e-6).expect("a tolerance")).expect("path data");
        for k in 0..=10 {
            let p = conic.eval(f64::from(k) / 10.0);
            let near = path.nearest(p).expect("finite").expect("a curve");
            // Path::from_svg reads an arc within 10⁻⁵ of its larger radius.
            let size = conic
                .to_elliptical_arc()
                .expect("an arc")
                .radii
                .max_element();
            assert!(near.distance <= 2e-5 * size, "{}", near.distance);
        }
    }
}

#[test]
fn json_keeps_every_bit() {
    let curve = quarter();
    let text = serde_json::to_string(&curve).expect("JSON");
    assert_eq!(
        text,
        "{\"points\":[[1.0,0.0],[1.0,1.0],[0.0,1.0]],\"weights\":[1.0,0.7071067811865476,1.0]}"
    );
    assert_eq!(
        serde_json::from_str::<RationalCurve<DVec2>>(&text).expect("valid"),
        curve
    );
    let circle = NurbsCurve::circle(DVec2::ZERO, 1.0).expect("finite");
    let text = serde_json::to_string(&circle).expect("JSON");
    assert_eq!(
        serde_json::from_str::<NurbsCurve<DVec2>>(&text).expect("valid"),
        circle
    );
    let bad = text.replace("\"degree\":2", "\"degree\":3");
    assert!(serde_json::from_str::<NurbsCurve<DVec2>>(&bad).is_err());
}

#[test]
fn json_of_surfaces_keeps_every_bit() {
    let sphere = NurbsSurface::sphere(DVec3::ZERO, 1.0, DVec3::Z).expect("finite");
    let text = serde_json::to_string(&sphere).expect("JSON");
    assert!(text.starts_with("{\"degreeU\":2,\"degreeV\":2,\"points\":[["));
    assert_eq!(
        serde_json::from_str::<NurbsSurface>(&text).expect("valid"),
        sphere
    );
    let bad = text.replace("\"degreeU\":2", "\"degreeU\":3");
    assert!(serde_json::from_str::<NurbsSurface>(&bad).is_err());
    let plane = NurbsSurface::plane(DVec3::ZERO, DVec3::X, DVec3::Y).expect("finite");
    let patch = &plane.patches()[0];
    let text = serde_json::to_string(patch).expect("JSON");
    assert_eq!(
        text,
        "{\"net\":[[0.0,0.0,0.0],[1.0,0.0,0.0],[0.0,1.0,0.0],[1.0,1.0,0.0]],\"weights\":[1.0,1.0,1.0,1.0],\"degreeU\":1,\"degreeV\":1}"
    );
    assert_eq!(
        &serde_json::from_str::<RationalPatch>(&text).expect("valid"),
        patch
    );
}

#[test]
fn surfaces_are_equal_within_a_tolerance() {
    let sphere = |radius: f64| NurbsSurface::sphere(DVec3::ZERO, radius, DVec3::Z).expect("finite");
    let (a, b) = (sphere(1.0), sphere(1.0 + 1e-9));
    assert!(a.approx_eq(&a, 0.0) && !a.approx_eq(&b, 1e-10) && a.approx_eq(&b, 2e-9));
    assert!(!a.approx_eq(&a.elevate_u().expect("low degrees"), 1.0));
    let heavier = |factor: f64| {
        let weights: Vec<f64> = a.weights().iter().map(|w| factor * w).collect();
        let net = (a.degree_u(), a.degree_v(), a.control_points());
        NurbsSurface::new(
            net.0,
            net.1,
            net.2,
            Some(&weights),
            a.knots_u(),
            a.knots_v(),
        )
        .expect("valid")
    };
    assert!(!a.approx_eq(&heavier(1.01), 1e-3) && a.approx_eq(&heavier(1.01), 0.02));
    // The weights of a patch count up to a factor.
    let patch = |surface: &NurbsSurface| surface.patches()[3].clone();
    assert!(patch(&a).approx_eq(&patch(&heavier(4.0)), 0.0));
    let weights = vec![1.0; 9];
    let plain = RationalPatch::new(patch(&a).control_points(), &weights, 2, 2).expect("valid");
    assert!(!patch(&a).approx_eq(&plain, 0.1) && patch(&a).approx_eq(&plain, 0.5));
}
