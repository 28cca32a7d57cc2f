//! Writes an SVG picture of a letter with a hole, its outward offset, and its intersections with a line:
//!
//!     cargo run --example outline > outline.svg

use casteljau::glam::DVec2;
use casteljau::path::{FillRule, Join, SvgOptions};
use casteljau::{Curve, Path, Spline};
use std::error::Error;

/// An italic "o": the outer subpath is counter-clockwise on the screen, the inner one clockwise.
const LETTER: &str = "M120 40C60 40 30 90 30 150S60 220 105 220 200 170 200 110 170 40 120 40Z\
    M118 65C155 65 168 90 168 118S140 195 107 195 62 180 62 148 85 65 118 65Z";

fn main() -> Result<(), Box<dyn Error>> {
    let letter = Path::from_svg(LETTER)?;
    let bold: Vec<Spline<DVec2>> = letter
        .subpaths()
        .collect::<Vec<_>>()
        .iter()
        .map(|outline| outline.offset_within(6.0, Join::Round, 0.01))
        .collect::<Result<_, _>>()?;
    let line = Curve::new(&[DVec2::new(10.0, 60.0), DVec2::new(220.0, 190.0)])?;
    let cuts = letter.intersections(&Path::new(&[Spline::from_curves(
        std::slice::from_ref(&line),
        false,
    )?]));
    let middle = line.eval(0.5);
    let inside = letter.contains(middle, FillRule::NonZero);

    println!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 230 250\">");
    let bold = Path::new(&bold).to_svg_with(&SvgOptions::new().precision(2))?;
    println!("<path d=\"{bold}\" fill=\"#cde\"/>");
    println!(
        "<path d=\"{}\" fill=\"#246\"/>",
        letter.to_svg_with(&SvgOptions::new().precision(2))?
    );
    println!(
        "<path d=\"{}\" stroke=\"#c40\"/>",
        line.to_svg_with(&SvgOptions::new().precision(2))?
    );
    for cut in &cuts {
        println!(
            "<circle cx=\"{:.2}\" cy=\"{:.2}\" r=\"4\" fill=\"#c40\"/>",
            cut.point.x, cut.point.y
        );
    }
    println!("</svg>");
    eprintln!(
        "area {:.1}, length {:.1}, {} cuts, the middle of the line is {}",
        letter.area(),
        letter.length(),
        cuts.len(),
        if inside { "inside" } else { "outside" }
    );
    Ok(())
}
