//! Finds Chromium and its driver, or installs them.

use crate::shell;
use anyhow::{Result, bail};
use std::env;
use std::fs;
use std::path::{Path, PathBuf};

const BROWSERS: [&str; 4] = [
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
];
const DRIVERS: [&str; 2] = ["chromedriver", "chromium.chromedriver"];
const MAC_CHROME: &str = "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome";

/// The flags of every browser that the tests start; tests/page/browser.js has the same.
const FLAGS: [&str; 8] = [
    "--headless",
    "--no-sandbox", // as root Chromium refuses to start without
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
];

/// A browser to test in; without a driver (Playwright's own download has none) only pages can be tested.
pub(crate) struct Browser {
    pub(crate) chrome: PathBuf,
    pub(crate) driver: Option<PathBuf>,
}

/// One that is there; else from apt, as root on Debian and its kin; else Playwright's download.
pub(crate) fn find() -> Result<Browser> {
    if let Some(browser) = found() {
        return Ok(browser);
    }
    if can_apt()
        && apt().is_ok()
        && let Some(browser) = found()
    {
        return Ok(browser);
    }
    if let Some(chrome) = playwright() {
        return Ok(Browser {
            chrome,
            driver: driver(),
        });
    }
    bail!(
        "no browser: install Chromium and its driver (Debian: apt-get install chromium chromium-driver), or set CHROME_PATH"
    )
}

fn found() -> Option<Browser> {
    let given = env::var_os("CHROME_PATH").map(PathBuf::from);
    let mac = Some(PathBuf::from(MAC_CHROME)).filter(|path| path.exists());
    let chrome = given.or_else(|| on_path(&BROWSERS)).or(mac)?;
    Some(Browser {
        chrome,
        driver: driver(),
    })
}

fn driver() -> Option<PathBuf> {
    env::var_os("CHROMEDRIVER")
        .map(PathBuf::from)
        .or_else(|| on_path(&DRIVERS))
}

fn on_path(names: &[&str]) -> Option<PathBuf> {
    let folders = env::split_paths(&env::var_os("PATH")?).collect::<Vec<_>>();
    let candidates = names
        .iter()
        .flat_map(|name| folders.iter().map(move |folder| folder.join(name)));
    candidates
        .map(|path| path.with_extension(env::consts::EXE_EXTENSION))
        .find(|path| path.is_file())
}

fn can_apt() -> bool {
    Path::new("/etc/debian_version").exists()
        && shell::output_of(&mut shell::command("id", &["-u"])).is_some_and(|id| id == "0")
}

fn apt() -> Result<()> {
    println!("installing chromium and chromium-driver (apt-get)");
    let apt = |args: &[&str]| {
        shell::run_quietly(shell::command("apt-get", args).env("DEBIAN_FRONTEND", "noninteractive"))
    };
    apt(&["update"])?;
    // Ubuntu has no chromium-driver; its chromium-browser is a snap that may not run as root in a container.
    apt(&[
        "install",
        "-y",
        "--no-install-recommends",
        "chromium",
        "chromium-driver",
    ])
}

/// Downloads the Chromium that belongs to the pinned playwright-core, and asks where it is.
fn playwright() -> Option<PathBuf> {
    println!("downloading Chromium (playwright)");
    let cli = "node_modules/playwright-core/cli.js";
    shell::run(&mut shell::node(&[cli, "install", "chromium"])).ok()?;
    let ask = "import('playwright-core').then(p => console.log(p.chromium.executablePath()))";
    let path = PathBuf::from(shell::output_of(&mut shell::node(&["-e", ask]))?);
    path.is_file().then_some(path)
}

/// The settings file that wasm-bindgen's test runner hands to the driver.
pub(crate) fn driver_settings(browser: &Browser) -> Result<PathBuf> {
    let path = shell::target_dir().join("webdriver.json");
    let chrome = browser.chrome.to_string_lossy();
    let json =
        format!("{{\"goog:chromeOptions\": {{\"binary\": {chrome:?}, \"args\": {FLAGS:?}}}}}\n");
    fs::write(&path, json)?;
    Ok(path)
}
