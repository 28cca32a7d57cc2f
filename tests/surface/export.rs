//! Meshes as files. The table was made by another program from the definitions of the formats; tests/js/export.test.js
//! reads it, too, and asks the validator of glTF.

use casteljau::{Error, Grid, Indices, Mesh, Surface, TeapotOptions};
use serde_json::Value;

fn table() -> Vec<Value> {
    let table: Value = serde_json::from_str(include_str!("../texts/meshes.json")).unwrap();
    table.as_array().unwrap().clone()
}

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().into_iter().flatten();
    list.map(|number| number.as_f64().unwrap()).collect()
}

#[allow(
    clippy::cast_possible_truncation,
    reason = "the table's numbers are f32"
)]
fn floats(value: &Value) -> Vec<f32> {
    numbers(value).into_iter().map(|x| x as f32).collect()
}

fn indices(value: &Value) -> Indices {
    let list = value.as_array().unwrap().iter();
    Indices::U16(
        list.map(|i| u16::try_from(i.as_u64().unwrap()).unwrap())
            .collect(),
    )
}

fn mesh<T>(entry: &Value, read: fn(&Value) -> Vec<T>) -> Mesh<T> {
    Mesh {
        positions: read(&entry["positions"]),
        normals: read(&entry["normals"]),
        uvs: floats(&entry["uvs"]),
        patch_ids: Vec::new(),
        indices: indices(&entry["indices"]),
        quads: entry["quads"].is_array().then(|| indices(&entry["quads"])),
        patch_ranges: Vec::new(),
    }
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[test]
fn table_of_files() {
    for entry in table() {
        let [obj, stl, glb] = if entry["precision"] == "f64" {
            let mesh = mesh(&entry, numbers);
            [
                mesh.to_obj().unwrap(),
                hex(&mesh.to_stl().unwrap()),
                hex(&mesh.to_glb().unwrap()),
            ]
        } else {
            let mesh = mesh(&entry, floats);
            [
                mesh.to_obj().unwrap(),
                hex(&mesh.to_stl().unwrap()),
                hex(&mesh.to_glb().unwrap()),
            ]
        };
        assert_eq!(obj, entry["obj"].as_str().unwrap(), "{}", entry["name"]);
        assert_eq!(stl, entry["stl"].as_str().unwrap(), "{}", entry["name"]);
        assert_eq!(glb, entry["glb"].as_str().unwrap(), "{}", entry["name"]);
    }
}

#[test]
fn sizes() {
    let teapot = Surface::teapot(TeapotOptions::default());
    let mesh = teapot.grid(Grid::from(16), true).unwrap();
    let stl = mesh.to_stl().unwrap();
    assert_eq!(stl.len(), 84 + 50 * 16_384);
    let obj = mesh.to_obj().unwrap();
    let count = |word: &str| obj.lines().filter(|line| line.starts_with(word)).count();
    assert_eq!(
        [count("v "), count("vt "), count("vn "), count("f ")],
        [9248, 9248, 9248, 8192]
    );
    // 65,536 vertices would use the number that glTF keeps for itself: 32 bits.
    for (segments, width) in [(254, 2), (255, 4)] {
        let patch = teapot.patch(0).unwrap();
        let mesh = patch.grid(Grid::from(segments), false).unwrap();
        assert!(matches!(mesh.indices, Indices::U16(_)));
        let vertices = (segments + 1) * (segments + 1);
        let binary = 4 * (3 + 3 + 2) * vertices + width * 6 * segments * segments;
        let glb = mesh.to_glb().unwrap();
        assert_eq!(glb.len() % 4, 0);
        assert!((0..1500).contains(&(glb.len() - binary)), "{}", glb.len());
    }
}

/// The digits of numbers: shortest, and every one gives its number back.
#[test]
fn digits_of_obj_give_the_numbers_back() {
    let mut random = 1_u64;
    let mut next = || {
        random = random
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        f32::from_bits(u32::try_from(random >> 32).unwrap())
    };
    let positions: Vec<f32> = (0..3000)
        .map(|_| next())
        .filter(|x| x.is_finite())
        .collect();
    let positions = positions[..positions.len() / 3 * 3].to_vec();
    let mesh = Mesh {
        normals: positions.clone(),
        positions,
        ..Mesh::default()
    };
    let obj = mesh.to_obj().unwrap();
    let words = obj
        .lines()
        .filter(|line| line.starts_with("v "))
        .flat_map(|line| line.split(' ').skip(1));
    let read: Vec<f32> = words.map(|word| word.parse().unwrap()).collect();
    assert_eq!(read, mesh.positions);
}

#[test]
fn meshes_that_do_not_belong_together_are_refused() {
    let good = Mesh {
        positions: vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0],
        normals: vec![0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0],
        indices: Indices::U16(vec![0, 1, 2]),
        ..Mesh::<f64>::default()
    };
    assert!(good.to_glb().is_ok());
    let refused = |change: &dyn Fn(&mut Mesh<f64>), message: &str| {
        let mut mesh = good.clone();
        change(&mut mesh);
        let errors: [Error; 3] = [
            mesh.to_obj().unwrap_err(),
            mesh.to_stl().unwrap_err(),
            mesh.to_glb().unwrap_err(),
        ];
        for error in errors {
            assert_eq!(error.to_string(), message);
        }
    };
    refused(
        &|m| m.indices = Indices::U32(vec![0, 1, 3]),
        "indices: expected an index from 0 to 2, got 3",
    );
    refused(
        &|m| m.indices = Indices::U16(vec![0, 1]),
        "indices: expected 3 vertex numbers for each face, got 2",
    );
    refused(
        &|m| m.positions.truncate(8),
        "positions: expected 3 numbers for each vertex, got 8",
    );
    refused(
        &|m| m.normals.truncate(6),
        "normals: expected 3 numbers for each vertex, got 6",
    );
    refused(
        &|m| m.uvs = vec![0.0],
        "uvs: expected 2 numbers for each vertex, got 1",
    );
    refused(
        &|m| m.positions[4] = f64::NAN,
        "positions[4]: expected a finite number, got NaN",
    );
    let mut wide = good.clone();
    wide.positions[0] = 1e39;
    assert!(wide.to_obj().is_ok());
    for error in [wide.to_stl().unwrap_err(), wide.to_glb().unwrap_err()] {
        let message = "positions: expected numbers that 32 bits can hold, got 1e39";
        assert_eq!(error.to_string(), message);
    }
}
