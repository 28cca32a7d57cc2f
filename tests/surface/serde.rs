//! Serialization with serde: the same form as JavaScript's `toJSON`, checked as by the constructors.

use casteljau::curve::IntersectionKind;
use casteljau::glam::{DVec2, DVec3};
use casteljau::mesh::TessellationOptions;
use casteljau::models::Up;
use casteljau::path::FillRule;
use casteljau::spline::{Interpolation, JointMode};
use casteljau::{Curve, Easing, Grid, Patch, Path, Spline, Surface, TeapotOptions};
use std::fmt::Debug;

const CURVE: &str = r#"{"points":[[0.0,0.5],[1.0,2.0],[2.0,0.1]]}"#;
const SPLINE: &str =
    r#"{"points":[[0.0,0.0],[1.0,2.0],[2.0,0.0],[3.0,0.0]],"degrees":[2,1],"closed":false}"#;

#[test]
fn a_curve_is_read_and_written_as_in_javascript() {
    let curve: Curve<DVec2> = serde_json::from_str(CURVE).unwrap();
    assert_eq!(curve.control_points()[2], DVec2::new(2.0, 0.1));
    assert_eq!(serde_json::to_string(&curve).unwrap(), CURVE);
}

#[test]
fn a_spline_keeps_its_degrees() {
    let spline: Spline<DVec2> = serde_json::from_str(SPLINE).unwrap();
    assert_eq!(spline.degrees(), [2, 1]);
    assert_eq!(serde_json::to_string(&spline).unwrap(), SPLINE);
}

#[test]
fn a_path_is_a_list_of_splines() {
    let text = r#"{"subpaths":[{"points":[[0.0,0.0],[1.0,2.0]],"degrees":[1],"closed":false},{"points":[[0.0,0.0],[1.0,2.0]],"degrees":[2],"closed":true}]}"#;
    let path: Path = serde_json::from_str(text).unwrap();
    assert_eq!(
        path.to_svg(None, None).unwrap(),
        "M0,0 L1,2 M0,0 Q1,2 0,0 Z"
    );
    assert_eq!(serde_json::to_string(&path).unwrap(), text);
    assert!(serde_json::from_str::<Path>(&text.replace("[2]", "[3]")).is_err());
}

#[test]
fn a_patch_keeps_its_degrees() {
    let net: Vec<DVec3> = (0..6)
        .map(|i| DVec3::new(f64::from(i % 3), f64::from(i / 3), 0.25))
        .collect();
    let text = serde_json::to_string(&Patch::new(&net, 2, 1).unwrap()).unwrap();
    assert!(text.ends_with(r#""degreeU":2,"degreeV":1}"#), "{text}");
    let patch: Patch = serde_json::from_str(&text).unwrap();
    assert_eq!(patch.control_points(), net);
}

#[test]
fn what_is_read_is_checked() {
    let read = |text| {
        serde_json::from_str::<Curve<DVec2>>(text)
            .unwrap_err()
            .to_string()
    };
    assert!(read(r#"{"points":[[1,2]]}"#).contains("expected 2 to 65 control points"));
    let spline = SPLINE.replace("[2,1]", "[2,2]");
    assert!(serde_json::from_str::<Spline<DVec2>>(&spline).is_err());
}

#[test]
fn a_surface_keeps_its_patches() {
    let teacup = Surface::teacup(Up::Z);
    let text = serde_json::to_string(&teacup).unwrap();
    assert_eq!(serde_json::from_str::<Surface>(&text).unwrap(), teacup);
    let wrong = text.replacen(r#""degreeU":3"#, r#""degreeU":2"#, 1);
    let error = serde_json::from_str::<Surface>(&wrong).unwrap_err();
    assert!(error.to_string().contains("vertex indices"), "{error}");
}

#[test]
fn an_easing_is_its_four_numbers() {
    let easing = Easing::new(0.25, 0.1, 0.25, 1.0).unwrap();
    let text = serde_json::to_string(&easing).unwrap();
    assert_eq!(text, "[0.25,0.1,0.25,1.0]");
    assert_eq!(serde_json::from_str::<Easing>(&text).unwrap(), easing);
    assert!(serde_json::from_str::<Easing>("[2,0,0,0]").is_err());
}

/// Serializes a value, checks that it is read back equal, and returns the text.
fn there_and_back<T: serde::Serialize + serde::de::DeserializeOwned + PartialEq + Debug>(
    value: T,
) -> String {
    let text = serde_json::to_string(&value).unwrap();
    assert_eq!(serde_json::from_str::<T>(&text).unwrap(), value);
    text
}

#[test]
fn results_and_options_have_the_names_of_javascript() {
    let curve = Curve::cubic(DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y);
    assert_eq!(
        there_and_back(curve.bounds()),
        r#"{"min":[0.0,0.0],"max":[0.75,1.0]}"#
    );
    there_and_back(curve.nearest(DVec2::new(3.0, 0.5)).unwrap());
    there_and_back(curve.intersections(&Curve::line(DVec2::ZERO, DVec2::ONE)));
    there_and_back(curve.flatten(0.1).unwrap());
    there_and_back(curve.reduce());
    let overlap = IntersectionKind::Overlap {
        t_end: 0.5,
        u_end: 1.0,
    };
    assert_eq!(
        there_and_back(overlap),
        r#"{"overlap":{"tEnd":0.5,"uEnd":1.0}}"#
    );
    assert_eq!(there_and_back(IntersectionKind::Cross), r#""cross""#);
    assert_eq!(there_and_back(FillRule::EvenOdd), r#""evenodd""#);
    assert_eq!(there_and_back(JointMode::C2), r#""c2""#);
    assert_eq!(
        there_and_back(Interpolation::CatmullRom { alpha: 0.5 }),
        r#"{"catmull-rom":{"alpha":0.5}}"#
    );
    there_and_back(TessellationOptions::tolerance(0.01));
    there_and_back(TeapotOptions::default());
    there_and_back(Surface::teacup(Up::Z).grid(Grid::from(2), true).unwrap());
    there_and_back(Surface::teacup(Up::Z).topology());
}
