//! Surfaces as text.

use super::Surface;
use std::fmt::{Arguments, Display, LowerExp, Write};

impl Surface {
    /// The surface as text, which [`parse`](Self::parse) reads back to an equal one, bit for bit.
    ///
    /// Only vertices that a move has brought to one place are joined when they are read, as in every new surface.
    ///
    /// The row `surface`; `vertices` and their number, then a row x y z for each; `patches` and their number, then for
    /// each a row with its degrees in u and v, and below it its net: a row for each j with the vertex numbers, from 0,
    /// of its points Pᵢⱼ.
    ///
    /// ```
    /// use casteljau::{Surface, glam::DVec3};
    ///
    /// let square = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(1.0, 1.0, 0.5)];
    /// let surface = Surface::new(square.to_vec(), vec![0, 1, 2, 3], 1, 1)?;
    /// let text = surface.to_text();
    /// assert_eq!(
    ///     text.lines().collect::<Vec<_>>(),
    ///     ["surface", "vertices 4", "0 0 0", "1 0 0", "0 1 0", "1 1 0.5", "patches 1", "1 1", "0 1", "2 3"],
    /// );
    /// assert_eq!(Surface::parse(&text), Ok(surface));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn to_text(&self) -> String {
        let mut text = format!("surface\nvertices {}\n", self.vertices().len());
        for vertex in self.vertices() {
            let [x, y, z] = vertex.to_array().map(written);
            push(&mut text, format_args!("{x} {y} {z}\n"));
        }
        push(&mut text, format_args!("patches {}\n", self.patch_count()));
        for patch in 0..self.patch_count() {
            let [degree_u, degree_v] = self.degrees(patch).unwrap_or_default();
            push(&mut text, format_args!("{degree_u} {degree_v}\n"));
            let indices = self.patch_indices(patch).unwrap_or_default();
            for (place, index) in indices.iter().enumerate() {
                let last = place % (degree_u + 1) == degree_u;
                push(
                    &mut text,
                    format_args!("{index}{}", if last { '\n' } else { ' ' }),
                );
            }
        }
        text
    }
}

/// Writing to a String cannot fail.
pub(crate) fn push(text: &mut String, words: Arguments<'_>) {
    let _ = text.write_fmt(words);
}

/// The fewest digits that give the number back, laid out as JavaScript does it (but −0 keeps its sign): with an
/// exponent from 10²¹ on and below 10⁻⁶.
pub(crate) fn written(x: impl Display + LowerExp) -> String {
    let scientific = format!("{x:e}");
    let exponent = scientific.rsplit('e').next().map(str::parse::<i32>);
    match exponent {
        Some(Ok(21..)) => scientific.replace('e', "e+"),
        Some(Ok(..-6)) => scientific,
        _ => x.to_string(),
    }
}
