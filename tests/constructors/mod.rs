//! Constructors and options with extreme arguments: they refuse them or return finite points, and never panic.
//! (`Curve::line`, `quad` and `cubic` panic, as documented, where `Curve::new` returns an error.) Coordinates and numbers
//! of curves, splines and patches: tests/generated/invalid.rs.

use casteljau::glam::{DMat4, DVec2, DVec3};
use casteljau::mesh::{Detail, TessellationOptions, View, Weld, Wire, WireframeOptions};
use casteljau::models::{Height, Up};
use casteljau::path::PathBuilder;
use casteljau::{
    Easing, Error, Grid, MAX_COORDINATE, Patch, Path, Point, Spline, Surface, TeapotOptions,
};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

const VALUES: [f64; 15] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    1e308,
    -1e308,
    MAX_COORDINATE,
    -MAX_COORDINATE,
    1e150,
    f64::MIN_POSITIVE,
    5e-324,
    -5e-324,
    0.0,
    -0.0,
    1.0,
];

const COUNTS: [usize; 11] = [0, 1, 2, 3, 4, 7, 16, 64, 65, 66, 257];

const DEGREES: [usize; 9] = [0, 1, 2, 3, 63, 64, 65, usize::MAX / 2, usize::MAX];

/// Adds a segment with an extreme number.
type Command = for<'b> fn(&'b mut PathBuilder, f64) -> &'b mut PathBuilder;

fn is_coordinate(x: f64) -> bool {
    x.abs() <= MAX_COORDINATE
}

/// Checks that a result is an error, or consists of coordinates and was made from valid ones.
fn check<P: Point>(what: &str, valid: bool, result: Result<&[P], Error>) {
    match result {
        Ok(points) => {
            assert!(valid, "{what}: invalid arguments are accepted");
            let largest = points.iter().map(|p| p.max_abs()).fold(0.0, f64::max);
            assert!(
                largest <= MAX_COORDINATE * (1.0 + 1e-9),
                "{what}: {largest}"
            );
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

/// In wasm a panic cannot be caught.
#[cfg(not(target_family = "wasm"))]
#[test]
fn lines_quadratics_and_cubics_panic_as_documented() {
    for value in VALUES {
        let (p, q) = (DVec2::ONE, DVec2::new(1.0, value));
        let made = [
            std::panic::catch_unwind(|| casteljau::Curve::line(p, q)),
            std::panic::catch_unwind(|| casteljau::Curve::quad(p, q, p)),
            std::panic::catch_unwind(|| casteljau::Curve::cubic(q, p, p, p)),
        ];
        assert!(
            made.iter()
                .all(|curve| curve.is_ok() == is_coordinate(value)),
            "{value}"
        );
    }
}

#[test]
fn paths_from_extreme_arguments() {
    assert!(Path::new(&[]).is_empty());
    assert!(PathBuilder::new().build().is_ok_and(|path| path.is_empty()));
    let commands: [(bool, Command); 15] = [
        (false, |b, x| b.move_to(DVec2::new(x, 0.0))),
        (false, |b, x| b.line_to(DVec2::new(0.0, x))),
        (false, |b, x| b.quad_to(DVec2::new(0.0, x), DVec2::ONE)),
        (false, |b, x| {
            b.cubic_to(DVec2::ONE, DVec2::splat(x), DVec2::ONE)
        }),
        (false, |b, x| b.curve_to(&[DVec2::splat(x); 64])),
        (true, |b, x| b.curve_to(&[DVec2::splat(x); 65])),
        (true, |b, _| b.curve_to(&[])),
        (false, |b, x| {
            b.arc_to(DVec2::new(x, 2.0), 0.5, false, false, DVec2::ONE)
        }),
        (false, |b, x| {
            b.arc_to(DVec2::ONE, x, false, true, DVec2::ONE)
        }),
        (false, |b, x| {
            b.arc_to(DVec2::ONE, 0.0, true, true, DVec2::new(x, 1.0))
        }),
        (false, |b, x| b.polygon(&[DVec2::ONE, DVec2::splat(x)])),
        (false, |b, x| b.rect(DVec2::new(x, 0.0), DVec2::ONE)),
        (false, |b, x| {
            b.ellipse(DVec2::ONE, DVec2::new(1.0, x.abs()), 0.5)
        }),
        (false, |b, x| b.ellipse(DVec2::ONE, DVec2::ONE, x)),
        (false, |b, x| b.circle(DVec2::new(1.0, x), 2.0)),
    ];
    for value in VALUES {
        for (k, (is_refused, command)) in commands.iter().enumerate() {
            let mut builder = PathBuilder::new();
            builder.arc_tolerance(1e-6);
            command(&mut builder, value);
            builder.close();
            command(&mut builder, value);
            let built = builder.build();
            assert_eq!(
                built.is_ok(),
                !is_refused && is_coordinate(value),
                "{k}: {value}"
            );
            let path = built.unwrap_or_default();
            for curve in path.subpaths() {
                check("path", true, Ok(curve.control_points()));
            }
        }
        let mut builder = PathBuilder::new();
        builder.arc_tolerance(value);
        builder.arc_to(DVec2::ONE, 0.0, true, true, DVec2::X);
        assert_eq!(builder.build().is_ok(), value > 0.0);
        let arc = "M0 0A1 2 3 1 0 4 5";
        assert_eq!(Path::from_svg_with(arc, value).is_ok(), value > 0.0);
    }
    let far = DVec2::splat(MAX_COORDINATE);
    let outside = |path: Result<Path, _>| assert!(matches!(path, Err(Error::Item { .. })));
    outside(Path::circle(far, MAX_COORDINATE));
    outside(Path::ellipse(far, DVec2::new(MAX_COORDINATE, 1.0), 0.0));
    outside(Path::arc(far, MAX_COORDINATE, -1.0, 1.0));
    let arc_around =
        |sweep: u8| Path::from_svg(&format!("M0 3e150A3e150 3e150 0 1 {sweep} 3e150 0"));
    assert!(arc_around(1).is_ok(), "around the origin");
    let refused = arc_around(0).expect_err("around (3e150, 3e150)");
    assert_eq!(refused.expected, "coordinates from -2^500 to 2^500");
    assert!(refused.path.is_empty());
    for text in [
        "",
        "M",
        "M1e999 0",
        "M1e308-1e308L1 2",
        "M0 0A1e150 5e-324 1e308 1 1 1 1Z",
        "z",
    ] {
        let path = Path::from_svg(text).unwrap_or_default();
        for subpath in path.subpaths() {
            check(text, true, Ok(subpath.control_points()));
        }
    }
}

#[test]
fn easing_from_extreme_arguments() {
    let css = Easing::new(0.25, 0.1, 0.25, 1.0).expect("in range");
    for value in VALUES {
        for position in 0..4 {
            let mut handles = [0.5; 4];
            handles[position] = value;
            let [x1, y1, x2, y2] = handles;
            let valid = value.is_finite() && (position % 2 == 1 || (0.0..=1.0).contains(&value));
            let easing = Easing::new(x1, y1, x2, y2);
            assert_eq!(easing.is_ok(), valid, "{handles:?}");
            for x in VALUES.into_iter().filter(|x| !x.is_nan()) {
                assert!(easing.as_ref().is_ok_and(|e| e.eval(x).is_finite()) || !valid);
            }
        }
        assert!(css.to_linear(value).is_ok() || !(1e-4..1e300).contains(&value));
        for text in [
            "cubic-bezier(0, {}, 1, {})",
            "steps({})",
            "linear(0, {} {}%, 1)",
        ] {
            let text = text.replace("{}", &value.to_string());
            let easing = text.parse::<Easing>();
            assert!(
                easing.is_err() || easing.is_ok_and(|e| !e.eval(0.5).is_nan()),
                "{text}"
            );
        }
    }
}

/// Numbers of points and indices that fit no degree, and degrees whose products overflow.
#[test]
fn any_degree_and_any_number_of_points() {
    for count in COUNTS {
        let net: Vec<DVec3> = (0_u32..)
            .map(|k| DVec3::splat(f64::from(k)))
            .take(count)
            .collect();
        for degree in DEGREES {
            for closed in [false, true] {
                let _ = Spline::from_bspline(&net, degree, None, closed);
                for degrees in [vec![], vec![degree], vec![degree; 3]] {
                    let _ = Spline::with_degrees(net.clone(), &degrees, closed);
                }
            }
            for other in [1, 3, 64, usize::MAX] {
                let _ = Patch::new(&net, degree, other);
                for indices in [vec![], vec![0; 16], vec![u32::MAX; 4]] {
                    let _ = Surface::new(net.clone(), indices.clone(), degree, other);
                    let _ = Surface::with_degrees(net.clone(), indices, &[[degree, other]]);
                }
            }
        }
    }
}

/// Which parts a number selects.
fn teapot_options(bits: u32) -> TeapotOptions {
    let has = |part: u32| bits >> part & 1 == 1;
    let height = if has(6) {
        Height::Original
    } else {
        Height::Squashed
    };
    (TeapotOptions::new().height(height))
        .up(if has(7) { Up::Y } else { Up::Z })
        .rim(has(0))
        .body(has(1))
        .handle(has(2))
        .spout(has(3))
        .lid(has(4))
        .bottom(has(5))
}

#[test]
fn teapots_of_all_parts_and_of_none() {
    for bits in 0..1 << 8 {
        let options = teapot_options(bits);
        let surface = Surface::teapot(&options);
        assert_eq!(surface.patch_count() == 0, bits & 63 == 0);
        check("teapot", true, Ok(surface.vertices()));
    }
}

#[test]
fn meshes_with_extreme_options() {
    let net: Vec<DVec3> = (0..16)
        .map(|k| DVec3::new(f64::from(k), f64::from(k * k), 1.0))
        .collect();
    let patch = Patch::new(&net, 3, 3).expect("a patch");
    let view = |pixels, matrix: f64, width| View {
        pixels,
        view_projection: DMat4::from_cols_array(&[matrix; 16]),
        viewport: DVec2::new(width, 100.0),
    };
    let no_surface = Surface::teapot(&teapot_options(0));
    let mut details: Vec<Detail> = Vec::new();
    for value in VALUES {
        let views = [
            view(value, 1.0, 100.0),
            view(1.0, value, 100.0),
            view(1.0, 1.0, value),
        ];
        details.extend(views.map(Detail::Pixels));
        details.push(Detail::Tolerance(value));
    }
    let grids = [0, 1, usize::MAX].map(Grid::from);
    details.extend(grids.map(Detail::Segments));
    for detail in details {
        for weld in [Weld::Position, Weld::Normal, Weld::None] {
            let options = TessellationOptions::from(detail).weld(weld);
            let mesh = patch.tessellate(&options);
            let is_finite = |x: &f32| x.is_finite();
            assert!(mesh.is_err() || mesh.is_ok_and(|m| m.positions.iter().all(is_finite)));
            let _ = no_surface.tessellate(&options);
        }
    }
    assert!(grids.map(|grid| patch.grid(grid, true).is_ok()) == [false, true, false]);
    for lines in [0, 1, usize::MAX] {
        for value in VALUES {
            let tube = |sides| Wire::Tube {
                radius: value,
                sides,
            };
            let wires = [
                tube(0),
                tube(3),
                tube(usize::MAX),
                Wire::Ribbon { width: value },
            ];
            for wire in wires {
                let _ = no_surface.wireframe(&WireframeOptions::new().lines(lines).wire(wire));
            }
        }
    }
}
