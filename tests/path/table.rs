//! The table of valid and invalid path data, which tests/js/path.test.js also reads.

use crate::support::paths::bits;
use casteljau::Path;
use casteljau::path::SvgOptions;
use serde_json::Value;

/// One subpath of the table: `[closed, [degrees], [coordinates]]`.
fn check_subpaths(name: &Value, path: &Path, expected: &Value) {
    let subpaths = path.subpaths().collect::<Vec<_>>();
    let expected = expected.as_array().expect("subpaths");
    assert_eq!(subpaths.len(), expected.len(), "{name}: subpaths");
    for (spline, row) in subpaths.iter().zip(expected) {
        assert_eq!(Value::from(spline.is_closed()), row[0], "{name}: closed");
        let degrees: Vec<Value> = spline.degrees().into_iter().map(Value::from).collect();
        assert_eq!(Value::from(degrees), row[1], "{name}: degrees");
        let numbers = row[2].as_array().expect("coordinates").iter();
        let numbers = numbers.map(|n| n.as_f64().expect("a number").to_bits());
        let got = spline.control_points();
        assert_eq!(bits(got), numbers.collect::<Vec<_>>(), "{name}: {got:?}");
    }
}

#[test]
fn table_of_texts() {
    let table: Value = serde_json::from_str(include_str!("../texts/svg.json")).expect("JSON");
    for entry in table.as_array().expect("entries") {
        let name = &entry["name"];
        let d = entry["d"].as_str().expect("a text");
        let path = match (Path::from_svg(d), entry["error"].as_str()) {
            (Ok(path), None) => path,
            (Err(error), Some(message)) => {
                assert_eq!(error.to_string(), message, "{name}");
                assert_eq!(Value::from(error.offset), entry["offset"], "{name}");
                error.path
            }
            (result, _) => panic!("{name}: {result:?}"),
        };
        if let Some(subpaths) = entry.get("subpaths") {
            check_subpaths(name, &path, subpaths);
        }
        let svg = path.to_svg();
        if let Some(expected) = entry["svg"].as_str() {
            assert_eq!(svg, expected, "{name}");
        }
        let again = Path::from_svg(&svg).expect("own text");
        assert_eq!(again, path, "{name}: there and back");
        for (digits, key) in [(0, "brief0"), (2, "brief2"), (5, "brief5")] {
            if let Some(expected) = entry[key].as_str() {
                let brief = path
                    .to_svg_with(&SvgOptions::new().precision(digits))
                    .expect("no tolerance");
                assert_eq!(brief, expected, "{name}: {key}");
            }
        }
    }
}
