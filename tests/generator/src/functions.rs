//! The functions for which cases are made, with the kinds of their arguments.

use std::fmt;
use std::sync::LazyLock;

/// Rows `Type Type …: function function … (name: kind, …)` for functions with the same arguments. An argument without a
/// kind has its name as its kind; `self` stands for the type's name in small letters. `arguments.rs` explains the kinds.
const TABLE: &[&str] = &[
    "Curve: new (points: control points, dimension: any dimension)",
    "Curve: from_basis (basis, points: four points)",
    "Curve Spline Path Patch Surface RationalSurface: from_json to_json bounds control_bounds (self)",
    "Curve: bernstein (degree: any degree, t)",
    "Curve: basis_matrix (basis: named basis)",
    "Curve: interpolate (points: few points, ts: optional distinct parameters)",
    "Curve: degree start end line quad cubic derivative halve reduce cusps classify (self)",
    "Curve Spline: dimension (self)",
    "Curve Spline Patch: control_points (self)",
    "Curve: approx_eq (self, other, tolerance)",
    "Curve: eval tangent normal curvature torsion split de_casteljau (self, t)",
    "Curve: eval_at split_at (self, ts: parameters)",
    "Curve Spline Path: sample equidistant_times (self, segments)",
    "Curve: sample_into (self, count: segments)",
    "Curve: derivative_at (self, t, k: order)",
    "Curve Spline: frames (self: self3, segments)",
    "Curve: frames_at (self: self3, ts: parameters, normal: optional direction)",
    "Curve Spline Path: length (self, tolerance: optional tolerance)",
    "Curve Spline Path: time_at_length (self, s: length, tolerance: optional tolerance)",
    "Curve Spline: point_at_length (self, s: length)",
    "Curve Spline: area hull self_intersections (self: self2)",
    "Curve: moments inflections (self: self2)",
    "Curve: subsegment (self, t0: t, t1: t)",
    "Curve Spline Path: reverse (self)",
    "Curve Patch: elevate (self)",
    "Curve Spline Path Patch Surface RationalSurface: transform (self, map)",
    "Curve: to_basis (curve: cubic, basis)",
    "Curve: flatten flatten_with (self, tolerance)",
    "Curve: subdivide (self, tolerance: coarse tolerance)",
    "Curve: intersections (self: self2, other)",
    "Curve: intersections_with_spline (self: self2, spline: spline2)",
    "Curve Spline Path Patch Surface RationalSurface: nearest (self, p: point)",
    "Curve: extrema (self, axis)",
    "Curve Spline Path: times_at_coordinate (self, axis, value: coordinate)",
    "Curve: tangents_from (self: self2, p: point)",
    "Curve: distance_to hausdorff (self, other)",
    "Curve: offset (self: self2, distance: length, tolerance: optional tolerance)",
    "Curve Spline: trace (self: self2, tolerance: optional tolerance)",
    "Curve Spline: to_svg (self: self2, precision: optional precision, tolerance: optional tolerance)",
    "Curve: chain (self, map: extreme map, t, other)",
    "RationalCurve: new (points: control points, weights)",
    "RationalCurve: conic (points: four points, w: weight)",
    "RationalCurve: from (curve)",
    "RationalCurve NurbsCurve: degree dimension control_points points weights start end to_json from_json (self)",
    "RationalCurve NurbsCurve: reverse elevate bounds control_bounds length (self)",
    "RationalCurve: halve reparametrize (self)",
    "RationalCurve: eval split (self, t)",
    "RationalCurve: tangent normal curvature (self, t: unit)",
    "RationalCurve: eval_at split_at (self, ts: parameters)",
    "RationalCurve NurbsCurve: sample (self, segments)",
    "RationalCurve: derivative_at (self, t: unit, k: order)",
    "RationalCurve: subsegment (self, t0: t, t1: t)",
    "RationalCurve NurbsCurve: time_at_length point_at_length (self, s: length)",
    "RationalCurve NurbsCurve: area (self: self2)",
    "RationalCurve: inflections to_elliptical_arc (self: self2)",
    "RationalCurve NurbsCurve: intersections (self: self2, other)",
    "RationalCurve NurbsCurve: self_intersections (self: self2)",
    "RationalCurve: intersections_with_curve (self: self2, curve: curve2)",
    "RationalCurve NurbsCurve: extrema (self, axis)",
    "RationalCurve NurbsCurve: nearest (self, p: point)",
    "RationalCurve NurbsCurve: flatten (self, tolerance: flatten tolerance)",
    "RationalCurve NurbsCurve: to_spline (self, tolerance: coarse tolerance)",
    "RationalCurve NurbsCurve: trace to_svg (self: self2, tolerance: coarse tolerance)",
    "RationalCurve NurbsCurve: transform (self, map)",
    "RationalCurve NurbsCurve: project (self, map: projective map)",
    "RationalCurve NurbsCurve: approx_eq (self, tolerance)",
    "NurbsCurve: new knots closed is_closed domain segments joints greville (self)",
    "NurbsCurve: arc (self, start: coordinate, end: coordinate)",
    "NurbsCurve: circle (self, radius: length)",
    "NurbsCurve: ellipse (self, radius: length, other_radius: length, rotation: unit)",
    "NurbsCurve: interpolate (points: many points, degree: low degree)",
    "NurbsCurve: from (spline)",
    "NurbsCurve: eval tangent normal curvature split (self, t: nurbs t)",
    "NurbsCurve: eval_at refine (self, ts: nurbs parameters)",
    "NurbsCurve: derivative_at (self, t: nurbs t, k: order)",
    "NurbsCurve: insert_knot (self, t: nurbs t, times: index)",
    "NurbsCurve: remove_knot (self, t: nurbs t, tolerance: optional tolerance)",
    "NurbsCurve: subsegment (self, t0: nurbs t, t1: nurbs t)",
    "RationalPatch: new degree_u degree_v weights control_points to_json from_json bounds control_bounds elevate (self)",
    "RationalPatch: from (patch)",
    "RationalPatch: eval partials normal curvature (self, u: t, v: t)",
    "RationalPatch: isocurve_at_u split_u (self, u: t)",
    "RationalPatch: isocurve_at_v split_v (self, v: t)",
    "RationalPatch NurbsSurface: project (self, map: projective map)",
    "RationalPatch NurbsSurface: transform (self, map)",
    "RationalPatch NurbsSurface: approx_eq (self, tolerance)",
    "NurbsSurface: new degree_u degree_v weights control_points to_json from_json bounds control_bounds (self)",
    "NurbsSurface: knots_u knots_v domain domain_u domain_v joints_u joints_v patches elevate_u elevate_v reverse to_surface (self)",
    "NurbsSurface: plane (points: space points)",
    "NurbsSurface: sphere (points: space points, radius: length)",
    "NurbsSurface: cylinder cone (points: space points, radius: length, height: length)",
    "NurbsSurface: torus (points: space points, major: length, minor: length)",
    "NurbsSurface: ruled (curve: nurbscurve3, other)",
    "NurbsSurface: extrude (curve: nurbscurve3, vector: point)",
    "RationalSurface: solid_of_revolution (curve: nurbscurve3, origin: point, axis: direction, angle: unit)",
    "NurbsSurface: revolve (curve: nurbscurve3, origin: point, axis: direction, angle: unit)",
    "NurbsSurface: loft (curve: nurbscurve3, other, degree: low degree)",
    "NurbsSurface: eval partials normal curvature (self, u: surface u, v: surface v)",
    "NurbsSurface: isocurve_at_u split_u (self, u: surface u)",
    "NurbsSurface: isocurve_at_v split_v (self, v: surface v)",
    "NurbsSurface: insert_knot_u (self, u: surface u, times: index)",
    "NurbsSurface: insert_knot_v (self, v: surface v, times: index)",
    "Spline: new (points: many points, degree: low degree, closed)",
    "Spline Surface RationalSurface: with_degrees (self)",
    "Spline: from_curves is_closed closed degrees cumulative_lengths to_bspline (self)",
    "Spline: from_bspline (points: many points, degree: low degree, knots: optional knots, closed)",
    "Spline: interpolate (points: many points, kind: interpolation, alpha: unit, closed)",
    "Spline: fit (points: stroke, tolerance: coarse tolerance, corner_angle: optional unit, closed)",
    "Spline Path: segment_count segments extrema (self)",
    "Spline: segment (self, k: index)",
    "Spline Path Patch: approx_eq (self, tolerance)",
    "Spline: eval tangent normal curvature split insert (self, t: spline t)",
    "Spline: eval_at split_at (self, ts: spline parameters)",
    "Spline: derivative_at (self, t: spline t, k: order)",
    "Spline: torsion (self: self3, t: spline t)",
    "Spline: subsegment (self, t0: spline t, t1: spline t)",
    "Spline: frames_at (self: self3, ts: spline parameters, normal: optional direction)",
    "Spline: continuity (self, joint, tolerance: optional tolerance)",
    "Spline: append (self, p: point)",
    "Spline: remove (self, joint)",
    "Spline: move_point (self, index: point index, to: point, modes: joint modes)",
    "Spline: set_joint (self, joint, mode: joint mode)",
    "Spline Path: flatten (self, tolerance: flatten tolerance)",
    "Spline: intersections (self: self2, other: spline2)",
    "Spline: intersections_with_curve (self: self2, curve: curve2)",
    "Spline Path: simplify (self, tolerance: coarse tolerance)",
    "Spline: offset (self: self2, distance: length, tolerance: optional tolerance, join)",
    "Spline: chain (self, map: extreme map, t: spline t, p: point)",
    "Path Patch: new (self)",
    "Path: from_svg (text: svg)",
    "Path: from_svg_with (text: svg, tolerance)",
    "Path: subpath_count is_empty subpaths moments self_intersections from (self)",
    "Path: subpath (self, k: index)",
    "Path: elements trace to_path2d (self, tolerance: optional tolerance)",
    "Path Patch Surface RationalSurface: area (self)",
    "Path: winding_number (self, p: point)",
    "Path: contains (self, p: point, rule)",
    "Path: intersections (self, other: path)",
    "Path: union intersect subtract exclude combine faces divide clip (self, other: path, rule)",
    "Path: remove_overlaps filled_area filled_moments (self, rule)",
    "Path: stroke (self, width: length, join, tolerance: optional tolerance)",
    "Path: stroke_sides (self, width: length, distance: length, join, tolerance: optional tolerance)",
    "Path: stroke_contains (self, p: point, width: length, join)",
    "Path: dash (self, s: length, width: length, offset: coordinate)",
    "Path: offset (self, distance: length, join, tolerance: optional tolerance)",
    "Path: round_corners round_corners_by (self, radius: length)",
    "Path: to_arcs (self, tolerance: coarse tolerance)",
    "Path: to_svg (self, precision: optional precision, tolerance: optional tolerance)",
    "Path: eval tangent normal curvature split (self, k: index, t)",
    "Path: eval_at (self, segments)",
    "Path: derivative_at (self, k: index, t, order)",
    "Path: point_at_length (self, s: length, tolerance: optional tolerance)",
    "Path: subsegment (self, k: index, t0: t, last: index, t1: t)",
    "Path: circle (self, p: point, radius: length, tolerance: optional tolerance)",
    "Path: ellipse (self, p: point, radius: length, other_radius: length, rotation: coordinate)",
    "Path: arc (self, p: point, radius: length, t0: t, t1: t)",
    "Path: rect (self, p: point, width: length, height: length, radius: length)",
    "Path: polygon (self, closed)",
    "Path: chain (self, map: extreme map, other: path, width: length)",
    "InkStroke: outline (points: plane stroke, width: length, part: unit, pressure: flag)",
    "Patch: from_basis (basis, points: sixteen points)",
    "Patch: degree_u degree_v flatness (self)",
    "Patch: eval partials normal curvature de_casteljau split (self, u: t, v: t)",
    "Patch: isocurve_at_u split_u (self, u: t)",
    "Patch: isocurve_at_v split_v (self, v: t)",
    "Patch Surface RationalSurface: move_point (self, index: point index, to: point)",
    "Patch Surface RationalSurface: intersect_ray (self, origin: point, direction)",
    "Patch Surface RationalSurface: grid grid_into (self, segments_u: cells, segments_v: cells, quads: flag)",
    "Patch Surface: grid_by (self, method, segments_u: cells, segments_v: cells, quads: flag)",
    "Patch Surface RationalSurface: tessellate (self, tolerance: mesh tolerance, cells: optional cells, weld)",
    "Patch Surface RationalSurface: tessellate_f64 (self, tolerance: mesh tolerance, cells: optional cells, weld)",
    "Patch: chain (self, map: extreme map, t, p: point)",
    "Surface: new (patch)",
    "Surface: teapot (parts, height, up)",
    "Surface: teacup teaspoon (up)",
    "Surface: parse (text: surface text)",
    "Surface RationalSurface: to_text from_patches vertices indices patch_count patches volume topology (self)",
    "Surface RationalSurface: degrees patch_indices patch (self, k: index)",
    "Surface RationalSurface: tessellate_view (self, view: projection, pixels, weld)",
    "Surface RationalSurface: isocurves (self, lines)",
    "Surface RationalSurface: trace_projected trace (self, view: projection, lines, tolerance: optional pixels)",
    "Surface RationalSurface: wireframe (self, lines, wire, width: wire width, sides)",
    "Surface: subdivide (self, tolerance: piece tolerance)",
    "Surface RationalSurface: chain (self, map: extreme map, p: point)",
    "RationalSurface: new (rationalpatch)",
    "RationalSurface: from (surface)",
    "RationalSurface: parse (text: weighted text)",
    "RationalSurface: weights weight_mismatches (self)",
    "RationalSurface: patch_weights (self, k: index)",
    "RationalSurface: eval (self, k: index, u: t, v: t)",
    "Mesh: new vertex_count triangle_count to_f32 to_stl to_glb (surface, segments_u: cells)",
    "Mesh: to_three (surface, segments_u: cells)",
    "Mesh: to_obj (surface, segments_u: cells, quads: flag)",
    "Grid: check (segments_u: cells, segments_v: cells, count: any count)",
    "Grid: quads (segments_u: cells, segments_v: cells)",
    "Easing: new (x1: unit, y1: handle, x2: unit, y2: handle)",
    "Easing: eval (x1: unit, y1: handle, x2: unit, y2: handle, x: t)",
    "Easing: to_linear (x1: unit, y1: handle, x2: unit, y2: handle, tolerance: easing tolerance)",
    "Easing: text (text: easing text)",
    "Address: read (text: address)",
];

/// The functions of both languages, and of one.
pub static FUNCTIONS: LazyLock<Vec<Signature>> = LazyLock::new(|| {
    TABLE
        .iter()
        .flat_map(|row| Signature::of_row(row))
        .collect()
});

/// A function and its arguments.
#[derive(Clone, Debug)]
pub struct Signature {
    /// As `Curve::offset`.
    pub name: &'static str,
    /// The names of the arguments and their kinds.
    pub arguments: Vec<(&'static str, &'static str)>,
}

impl Signature {
    fn of_row(row: &'static str) -> impl Iterator<Item = Self> {
        let (heads, arguments) = row.split_once(" (").expect("a parenthesis");
        let (types, names) = heads.split_once(": ").expect("a colon");
        let of_type = move |of: &'static str| names.split(' ').map(move |name| (of, name));
        types.split(' ').flat_map(of_type).map(move |(of, name)| {
            let own = arguments
                .trim_end_matches(')')
                .replace("self", &of.to_lowercase());
            let pair = |text: &'static str| text.split_once(": ").unwrap_or((text, text));
            Self {
                name: format!("{of}::{name}").leak(),
                arguments: own.leak().split(", ").map(pair).collect(),
            }
        })
    }
}

impl fmt::Display for Signature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let argument = |(name, kind): &(&str, &str)| match name == kind {
            true => (*name).to_owned(),
            false => format!("{name}: {kind}"),
        };
        let arguments: Vec<String> = self.arguments.iter().map(argument).collect();
        write!(f, "{}({})", self.name, arguments.join(", "))
    }
}

/// The row of a function, by its name in either language: `Curve::times_at_coordinate` and `Curve.timesAtCoordinate`.
/// Case and underscores do not count.
pub fn find(name: &str) -> Option<&'static Signature> {
    let is_same = |known: &&Signature| letters(known.name).eq(letters(name));
    FUNCTIONS.iter().find(is_same)
}

fn letters(name: &str) -> impl Iterator<Item = char> {
    let letters = name.chars().filter(char::is_ascii_alphanumeric);
    letters.map(|c| c.to_ascii_lowercase())
}
