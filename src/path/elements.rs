//! The drawing commands of a path as an iterator.

use super::Path;
use super::builder::PathBuilder;
use crate::curve::Curve;
use crate::curve::trace::PathSink;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::numeric::list::List;
use glam::DVec2;

/// A drawing command with absolute coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum PathElement {
    /// Starts a subpath.
    MoveTo(DVec2),
    /// A line to a point.
    LineTo(DVec2),
    /// A quadratic Bézier curve: its control point and its end.
    QuadTo(DVec2, DVec2),
    /// A cubic Bézier curve: its two control points and its end.
    CubicTo(DVec2, DVec2, DVec2),
    /// Closes the subpath.
    Close,
}

/// The commands of one segment: one command up to degree 3.
#[derive(Default)]
struct Elements(List<PathElement, 1>);

impl PathSink for Elements {
    fn move_to(&mut self, p: DVec2) {
        self.0.push(PathElement::MoveTo(p));
    }
    fn line_to(&mut self, p: DVec2) {
        self.0.push(PathElement::LineTo(p));
    }
    fn quad_to(&mut self, p1: DVec2, p: DVec2) {
        self.0.push(PathElement::QuadTo(p1, p));
    }
    fn cubic_to(&mut self, p1: DVec2, p2: DVec2, p: DVec2) {
        self.0.push(PathElement::CubicTo(p1, p2, p));
    }
    fn close(&mut self) {
        self.0.push(PathElement::Close);
    }
}

impl Path {
    /// The segments of all subpaths as curves, from the first to the last.
    ///
    /// Curves up to degree 3 need no allocation.
    pub fn segments(&self) -> impl Iterator<Item = Curve<DVec2>> + Clone + '_ {
        self.segment_points().map(Curve::from_slice)
    }

    /// The drawing commands of the path, the same that [`trace`](Self::trace) sends to a [`PathSink`], as an iterator.
    ///
    /// Segments above degree 3 are approximated by cubics within 10⁻⁴ of the diagonal of their control-point box. A closing line is a `LineTo` before the `Close`.
    ///
    /// ```
    /// use casteljau::{Path, glam::DVec2, path::PathElement};
    ///
    /// let path: Path = "M0 0L2 0L2 1".parse().expect("path data");
    /// let elements: Vec<_> = path.elements().collect();
    /// assert_eq!(elements[1], PathElement::LineTo(DVec2::new(2.0, 0.0)));
    /// assert_eq!(elements.len(), 3);
    /// ```
    pub fn elements(&self) -> impl Iterator<Item = PathElement> + '_ {
        self.all_elements(None)
    }

    /// [`elements`](Self::elements) with the largest distance of cubics from segments above degree 3.
    ///
    /// # Errors
    /// As [`Curve::trace_within`].
    pub fn elements_within(
        &self,
        tolerance: f64,
    ) -> Result<impl Iterator<Item = PathElement> + '_, Error> {
        check_tolerance(tolerance, self.max_abs())?;
        Ok(self.all_elements(Some(tolerance)))
    }

    /// A path of drawing commands, the opposite of [`elements`](Self::elements); see [`PathBuilder`].
    ///
    /// ```
    /// use casteljau::Path;
    ///
    /// let path: Path = "M0 0L2 0L2 1Z".parse().expect("path data");
    /// assert_eq!(Path::from_elements(path.elements())?, path);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`PathBuilder::build`].
    pub fn from_elements(elements: impl IntoIterator<Item = PathElement>) -> Result<Self, Error> {
        let mut builder = PathBuilder::new();
        for element in elements {
            match element {
                PathElement::MoveTo(p) => builder.move_to(p),
                PathElement::LineTo(p) => builder.line_to(p),
                PathElement::QuadTo(p1, p) => builder.quad_to(p1, p),
                PathElement::CubicTo(p1, p2, p) => builder.cubic_to(p1, p2, p),
                PathElement::Close => builder.close(),
            };
        }
        Ok(builder.build()?)
    }

    fn all_elements(&self, tolerance: Option<f64>) -> impl Iterator<Item = PathElement> + '_ {
        self.parts().flat_map(move |part| {
            let segments = part.segments().flat_map(move |points| {
                let mut elements = Elements::default();
                Curve::from_slice(points).trace_on(&mut elements, tolerance);
                elements.0
            });
            let close = part.closed.then_some(PathElement::Close);
            [PathElement::MoveTo(part.points[0])]
                .into_iter()
                .chain(segments)
                .chain(close)
        })
    }
}
