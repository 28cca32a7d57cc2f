//! The runner of wasm test binaries. It is a package of its own because two thirds of what the driver would compile are
//! its dependencies, and only the wasm tests need it.

fn main() -> anyhow::Result<()> {
    wasm_bindgen_cli::wasm_bindgen_test_runner::run_cli_with_args(std::env::args_os())
}
