//! Texts for the parsers: valid ones by small grammars, and ones that were mutated.

use crate::geometry::weight;
use crate::mutations::{mutated, tokens};
use crate::random::Rng;
use std::fmt::Write;

/// A text of a kind; `None` for a kind that is not a text.
pub(crate) fn text(rng: &mut Rng, kind: &str) -> Option<String> {
    let valid = match kind {
        "svg" => svg(rng),
        "surface text" => surface(rng, false),
        "weighted text" => surface(rng, true),
        "easing text" => easing(rng),
        "address" => address(rng),
        _ => return None,
    };
    // A quarter stays valid, and a few texts are nothing but tokens.
    Some(match rng.below(8) {
        0 | 1 => valid,
        2 => (0..rng.below(12)).map(|_| rng.pick(&tokens())).collect(),
        _ => mutated(rng, valid),
    })
}

/// A number in one of the forms that people and programs write.
fn number(rng: &mut Rng) -> String {
    let x = rng.signed() * rng.pick(&[1.0, 10.0, 1000.0]);
    match rng.below(8) {
        0 => format!("{x:.0}"),
        1 => format!("{x:.2}"),
        2 => format!("{x:e}"),
        3 => format!("{x:.3}").replace("0.", "."),
        4 => rng.pick(&["0", "1", "-1", ".5", "1e3"]).to_owned(),
        5 => format!("{:e}", x * rng.magnitude(-12.0, 15.0)),
        _ => format!("{x}"),
    }
}

fn numbers(rng: &mut Rng, count: usize) -> String {
    let mut text = String::new();
    for k in 0..count {
        text += if k > 0 {
            rng.pick(&[" ", ",", " , ", " "])
        } else {
            ""
        };
        text += &number(rng);
    }
    text
}

fn svg(rng: &mut Rng) -> String {
    let mut text = format!("M{}", numbers(rng, 2));
    for _ in 0..rng.below(8) {
        let (letter, count) = rng.pick(&[
            ("M", 2),
            ("L", 2),
            ("H", 1),
            ("V", 1),
            ("C", 6),
            ("S", 4),
            ("Q", 4),
            ("T", 2),
            ("A", 7),
            ("Z", 0),
        ]);
        let letter = if rng.chance(0.5) {
            letter.to_lowercase()
        } else {
            letter.to_owned()
        };
        text += rng.pick(&["", " ", "\n"]);
        text += &letter;
        for group in 0..if count == 0 { 1 } else { 1 + rng.below(3) } {
            text += if group > 0 { " " } else { "" };
            text += &if count == 7 {
                arc(rng)
            } else {
                numbers(rng, count)
            };
        }
    }
    text
}

fn arc(rng: &mut Rng) -> String {
    let (radii, end) = (numbers(rng, 3), numbers(rng, 2));
    let flags = rng.pick(&["0 0", "01", "1,0", "11"]);
    format!("{radii} {flags} {end}")
}

fn row(rng: &mut Rng) -> String {
    let words: Vec<String> = (0..3).map(|_| number(rng).replace("-.", "-0.")).collect();
    words.join(rng.pick(&[" ", "\t", ", "]))
}

/// `has_weights`: weights may follow the nets.
fn surface(rng: &mut Rng, has_weights: bool) -> String {
    let [m, n] = [1 + rng.below(3), 1 + rng.below(3)];
    let count = (m + 1) * (n + 1);
    let (patches, end) = (
        1 + rng.below(2),
        rng.pick(&["\n", "\r\n", "\n# a comment\n\n"]),
    );
    let mut text = String::new();
    if rng.chance(0.5) {
        let _ = write!(text, "{patches}{end}");
        for _ in 0..patches {
            let _ = write!(text, "{m} {n}{end}");
            for _ in 0..count {
                let _ = write!(text, "{}{end}", row(rng));
            }
        }
        return text;
    }
    let _ = write!(text, "surface{end}vertices {count}{end}");
    for _ in 0..count {
        let _ = write!(text, "{}{end}", row(rng));
    }
    let _ = write!(text, "patches {patches}{end}");
    for _ in 0..patches {
        let _ = write!(text, "{m} {n}{end}");
        for _ in 0..=n {
            let indices: Vec<String> = (0..=m).map(|_| rng.below(count).to_string()).collect();
            let _ = write!(text, "{}{end}", indices.join(" "));
        }
        if has_weights && rng.chance(0.8) {
            for _ in 0..=n {
                let weights: Vec<String> = (0..=m).map(|_| weight(rng).to_string()).collect();
                let _ = write!(text, "w {}{end}", weights.join(" "));
            }
        }
    }
    text
}

fn easing(rng: &mut Rng) -> String {
    let words = [
        "ease",
        "ease-in",
        "EASE-OUT",
        " ease-in-out ",
        "linear",
        "step-start",
        "transition: ease;",
    ];
    let (x1, y1, x2, y2) = (rng.unit(), number(rng), rng.unit(), number(rng));
    match rng.below(8) {
        0 => rng.pick(&words).to_owned(),
        1 => format!("{x1} {y1}, {x2} {y2}"),
        2 | 3 => {
            let count = rng.pick(&["1", "2", "+5", "40000", "2147483647"]);
            let position = rng.pick(&["", ", end", ",start", ", jump-none", ", Jump-Both"]);
            format!("steps({count}{position})")
        }
        4 | 5 => linear(rng),
        _ => format!("cubic-bezier({x1}, {y1},{x2}, {y2})"),
    }
}

fn linear(rng: &mut Rng) -> String {
    let stops: Vec<String> = (0..2 + rng.below(6))
        .map(|_| {
            let percentages = (0..rng.below(3)).map(|_| format!("{}%", number(rng)));
            let percentages: Vec<String> = percentages.collect();
            match rng.below(4) {
                0 => format!("{} {}", percentages.join(" "), number(rng)),
                1 => format!("/**/{} {}", number(rng), percentages.join(" ")),
                _ => format!("{} {}", number(rng), percentages.join(" ")),
            }
        })
        .collect();
    format!("linear({})", stops.join(","))
}

/// What may stand behind the `#` of the site's pages.
fn address(rng: &mut Rng) -> String {
    let pairs = |rng: &mut Rng| {
        let points: Vec<String> = (0..2 + rng.below(6))
            .map(|_| format!("{},{}", number(rng), number(rng)))
            .collect();
        points.join(rng.pick(&["+", "%20", " "]))
    };
    match rng.below(4) {
        0 => format!(
            "figure?points={}&t={}&show=hull,+split",
            pairs(rng),
            rng.unit()
        ),
        1 => format!(
            "teapot?model=cup&segments={}&u={}&step={}",
            rng.below(20),
            rng.unit(),
            number(rng)
        ),
        2 => {
            let points: Vec<String> = (0..2 + rng.below(5))
                .map(|_| {
                    format!(
                        "[{:.3},{:.3},{:.3}]",
                        9.0 * rng.signed(),
                        9.0 * rng.signed(),
                        8.0 * rng.unit()
                    )
                })
                .collect();
            let kind = rng.pick(&["natural", "catmull-rom"]);
            format!(
                "state={{\"points\":[{}],\"kind\":\"{kind}\",\"closed\":{},\"even\":true,\"frames\":\"minimising\",\"look\":\"ahead\"}}",
                points.join(","),
                rng.chance(0.5)
            )
        }
        _ => format!(
            "state={{\"d\":\"{}\",\"modes\":[[\"free\",\"g1\"]]}}",
            svg(rng).replace('\n', " ")
        ),
    }
}
