//! Reading and writing with serde: the form of JavaScript's `toJSON`, checked as by the constructors.

use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, Patch, Path, Spline};

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
