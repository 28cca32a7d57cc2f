//! Serialization with serde: the same form as JavaScript's `toJSON`, checked as by the constructors.

use crate::support::assert_refused;
use crate::support::nets::net;
use casteljau::curve::{Cubic, IntersectionKind, Quad};
use casteljau::glam::{DVec2, DVec3};
use casteljau::mesh::{Detail, TessellationOptions, WireframeOptions};
use casteljau::models::Up;
use casteljau::path::{
    CornerOptions, FillRule, InkOptions, OffsetOptions, StrokeOptions, SvgOptions,
};
use casteljau::spline::{FitOptions, Interpolation, JointMode, SimplifyOptions};
use casteljau::{Curve, Easing, Grid, Patch, Path, Spline, Surface, TeapotOptions};
use serde::{Serialize, de::DeserializeOwned};
use serde_json::{from_str, to_string};
use std::fmt::Debug;

/// Reads a text, and checks that the value is written as the same text.
fn read<T: Serialize + DeserializeOwned>(text: &str) -> T {
    let value: T = from_str(text).unwrap();
    assert_eq!(to_string(&value).unwrap(), text);
    value
}

#[test]
fn texts_are_those_of_javascript() {
    let text = r#"{"points":[[0.0,0.5],[1.0,2.0],[2.0,0.1]]}"#;
    let curve: Curve<DVec2> = read(text);
    assert_eq!(curve.control_points()[2], DVec2::new(2.0, 0.1));
    assert_eq!(Curve::from(read::<Quad<DVec2>>(text)), curve);
    assert!(from_str::<Cubic<DVec2>>(text).is_err());
    let text =
        r#"{"points":[[0.0,0.0],[1.0,2.0],[2.0,0.0],[3.0,0.0]],"degrees":[2,1],"closed":false}"#;
    assert_eq!(read::<Spline<DVec2>>(text).degrees(), [2, 1]);
    assert!(from_str::<Spline<DVec2>>(&text.replace("[2,1]", "[2,2]")).is_err());
    let points = r#""points":[[0.0,0.0],[1.0,2.0]],"degrees""#;
    let text = format!(
        r#"{{"subpaths":[{{{points}:[1],"closed":false}},{{{points}:[2],"closed":true}}]}}"#
    );
    let path: Path = read(&text);
    assert_eq!(path.to_string(), "M0,0 L1,2 M0,0 Q1,2 0,0 Z");
    assert!(from_str::<Path>(&text.replace("[2]", "[3]")).is_err());
    let easing: Easing = read("[0.25,0.1,0.25,1.0]");
    assert_eq!(Easing::new(0.25, 0.1, 0.25, 1.0), Ok(easing));
    assert!(from_str::<Easing>("[2,0,0,0]").is_err());
    let short = from_str::<Curve<DVec2>>(r#"{"points":[[1,2]]}"#);
    assert_refused(short, "points: expected 2 to 65 control points");
}

#[test]
fn patches_and_surfaces_keep_their_degrees() {
    let net = net(2, 1, |i, j| DVec3::new(i, j, 0.25));
    let text = to_string(&Patch::new(&net, 2, 1).unwrap()).unwrap();
    assert!(text.ends_with(r#""degreeU":2,"degreeV":1}"#), "{text}");
    assert_eq!(read::<Patch>(&text).control_points(), net);
    let text = to_string(&Surface::teacup(Up::Z)).unwrap();
    assert_eq!(read::<Surface>(&text), Surface::teacup(Up::Z));
    let wrong = text.replacen(r#""degreeU":3"#, r#""degreeU":2"#, 1);
    let error = from_str::<Surface>(&wrong).unwrap_err();
    assert!(error.to_string().contains("vertex indices"), "{error}");
}

/// Serializes a value, checks that it is read back equal, and returns the text.
fn there_and_back<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: T) -> String {
    let text = to_string(&value).unwrap();
    assert_eq!(from_str::<T>(&text).unwrap(), value);
    text
}

#[test]
fn options_that_are_left_out_have_their_defaults() {
    assert_eq!(
        from_str::<StrokeOptions>("{}").unwrap(),
        StrokeOptions::new()
    );
    assert_eq!(
        from_str::<CornerOptions>("{}").unwrap(),
        CornerOptions::new()
    );
    assert_eq!(
        from_str::<OffsetOptions>("{}").unwrap(),
        OffsetOptions::new()
    );
    assert_eq!(
        from_str::<WireframeOptions>("{}").unwrap(),
        WireframeOptions::new()
    );
    assert_eq!(from_str::<SvgOptions>("{}").unwrap(), SvgOptions::new());
    assert_eq!(
        from_str::<TeapotOptions>("{}").unwrap(),
        TeapotOptions::new()
    );
    let tolerance = r#"{"tolerance":0.5}"#;
    assert_eq!(
        from_str::<FitOptions>(tolerance).unwrap(),
        FitOptions::new(0.5)
    );
    assert_eq!(
        from_str::<SimplifyOptions>(tolerance).unwrap(),
        SimplifyOptions::new(0.5)
    );
    assert_eq!(
        from_str::<InkOptions>(r#"{"size":8}"#).unwrap(),
        InkOptions::new(8.0)
    );
    assert!(from_str::<FitOptions>("{}").is_err());
    let written = to_string(&TessellationOptions::from(Detail::Tolerance(0.5))).unwrap();
    let short = written.replace(r#","weld":"normal""#, "");
    assert!(short.len() < written.len());
    assert_eq!(
        from_str(&short).ok(),
        Some(TessellationOptions::from(Detail::Tolerance(0.5)))
    );
}

#[test]
fn results_and_options_have_the_names_of_javascript() {
    let curve = Curve::cubic(DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y);
    let bounds = r#"{"min":[0.0,0.0],"max":[0.75,1.0]}"#;
    assert_eq!(there_and_back(curve.bounds()), bounds);
    there_and_back(curve.nearest(DVec2::new(3.0, 0.5)).unwrap());
    there_and_back(curve.intersections(&Curve::line(DVec2::ZERO, DVec2::ONE)));
    there_and_back(curve.flatten(0.3).unwrap());
    there_and_back(curve.reduce());
    let (t_end, u_end) = (0.5, 1.0);
    let overlap = there_and_back(IntersectionKind::Overlap { t_end, u_end });
    assert_eq!(overlap, r#"{"overlap":{"tEnd":0.5,"uEnd":1.0}}"#);
    assert_eq!(there_and_back(IntersectionKind::Cross), r#""cross""#);
    assert_eq!(there_and_back(FillRule::EvenOdd), r#""evenodd""#);
    assert_eq!(there_and_back(JointMode::C2), r#""c2""#);
    let interpolation = there_and_back(Interpolation::CatmullRom { alpha: 0.5 });
    assert_eq!(interpolation, r#"{"catmull-rom":{"alpha":0.5}}"#);
    there_and_back(TessellationOptions::tolerance(0.01));
    there_and_back(TeapotOptions::new());
    there_and_back(SvgOptions::new().precision(2).arcs(false));
    there_and_back(Surface::teacup(Up::Z).grid(Grid::from(2), true).unwrap());
    there_and_back(Surface::teacup(Up::Z).topology());
}
