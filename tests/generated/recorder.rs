//! A target of drawings that records what is drawn.

use casteljau::Curve;
use casteljau::curve::PathSink;
use casteljau::glam::DVec2;

/// Records the curves of each subpath, and whether it was closed.
#[derive(Default)]
pub(crate) struct Recorder {
    pub(crate) subpaths: Vec<(Vec<Curve<DVec2>>, bool)>,
    /// Whether a number is not finite, or a subpath does not start with a `move_to`.
    pub(crate) is_bad: bool,
    at: DVec2,
}

impl Recorder {
    fn add(&mut self, points: &[DVec2]) {
        match (Curve::new(points), self.subpaths.last_mut()) {
            (Ok(curve), Some((curves, _))) => curves.push(curve),
            _ => self.is_bad = true,
        }
        self.at = points[points.len() - 1];
    }
}

impl PathSink for Recorder {
    fn move_to(&mut self, p: DVec2) {
        self.is_bad |= !p.is_finite();
        self.at = p;
        self.subpaths.push((Vec::new(), false));
    }
    fn line_to(&mut self, p: DVec2) {
        self.add(&[self.at, p]);
    }
    fn quad_to(&mut self, a: DVec2, p: DVec2) {
        self.add(&[self.at, a, p]);
    }
    fn cubic_to(&mut self, a: DVec2, b: DVec2, p: DVec2) {
        self.add(&[self.at, a, b, p]);
    }
    fn close(&mut self) {
        if let Some((_, closed)) = self.subpaths.last_mut() {
            *closed = true;
        }
    }
}
