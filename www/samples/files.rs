use casteljau::Surface;
use casteljau::mesh::{TessellationOptions, Weld};

pub(crate) fn sample(out: &mut String) {
    let text = "1\n1 1\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n"; // one patch of degree 1 × 1 and its points
    let saddle = Surface::parse(text).unwrap();
    writeln!(out, "area {:.6}", saddle.area());
    let mesh = saddle
        .tessellate(&TessellationOptions::segments(8).weld(Weld::Normal))
        .unwrap();
    let obj = mesh.to_obj().unwrap();
    writeln!(
        out,
        "OBJ: {} faces",
        obj.lines().filter(|line| line.starts_with("f ")).count()
    );
    writeln!(out, "STL: {} bytes", mesh.to_stl().unwrap().len());
    let glb = mesh.to_glb().unwrap();
    writeln!(out, "GLB: {}", String::from_utf8_lossy(&glb[..4]));
}
