use casteljau::{Surface, TeapotOptions};

pub(crate) fn sample(out: &mut String) {
    let lid = Surface::teapot(&TeapotOptions::default())
        .patch(20)
        .unwrap();
    for v in [0.0, 0.5, 1.0] {
        let partials = lid.partials(0.5, v);
        let [along, across] = [partials.u, partials.v].map(|d| d.length());
        let z = lid.normal(0.5, v).z;
        writeln!(
            out,
            "v = {v}: |Su| = {along:.3}, |Sv| = {across:.3}, normal z = {z:.3}"
        );
    }
}
