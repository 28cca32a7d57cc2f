//! HTML canvas contexts and `Path2D` objects as path sinks.

use crate::curve::trace::PathSink;
use glam::DVec2;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{CanvasRenderingContext2d, Path2d};

/// Draws on the object that JavaScript passed: a `Path2D`, or a 2D context of a canvas or an offscreen canvas. Methods
/// are looked up by name, so any object with the methods of a context works.
pub(crate) enum CanvasSink<'a> {
    Path(&'a Path2d),
    Context(&'a CanvasRenderingContext2d),
}

impl<'a> CanvasSink<'a> {
    pub(crate) fn new(target: &'a JsValue) -> Self {
        match target.dyn_ref::<Path2d>() {
            Some(path) => Self::Path(path),
            None => Self::Context(target.unchecked_ref()),
        }
    }
}

impl PathSink for CanvasSink<'_> {
    fn move_to(&mut self, p: DVec2) {
        match self {
            Self::Path(path) => path.move_to(p.x, p.y),
            Self::Context(context) => context.move_to(p.x, p.y),
        }
    }
    fn line_to(&mut self, p: DVec2) {
        match self {
            Self::Path(path) => path.line_to(p.x, p.y),
            Self::Context(context) => context.line_to(p.x, p.y),
        }
    }
    fn quad_to(&mut self, p1: DVec2, p: DVec2) {
        match self {
            Self::Path(path) => path.quadratic_curve_to(p1.x, p1.y, p.x, p.y),
            Self::Context(context) => context.quadratic_curve_to(p1.x, p1.y, p.x, p.y),
        }
    }
    fn cubic_to(&mut self, p1: DVec2, p2: DVec2, p: DVec2) {
        match self {
            Self::Path(path) => path.bezier_curve_to(p1.x, p1.y, p2.x, p2.y, p.x, p.y),
            Self::Context(context) => context.bezier_curve_to(p1.x, p1.y, p2.x, p2.y, p.x, p.y),
        }
    }
    fn close(&mut self) {
        match self {
            Self::Path(path) => path.close_path(),
            Self::Context(context) => context.close_path(),
        }
    }
}
