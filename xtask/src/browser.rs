//! Finding or installing Chromium and chromedriver, Firefox and WebKitGTK.

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
const FIREFOXES: [&str; 2] = ["firefox-esr", "firefox"];
const MAC_FIREFOX: &str = "/Applications/Firefox.app/Contents/MacOS/firefox";
const MAC_CHROME: &str = "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome";

/// Another apt-get may be running: seconds to wait for its lock.
const APT_WAITS: &str = "DPkg::Lock::Timeout=120";

/// The flags of every browser that the tests start; tests/page/browser.js uses the same flags.
const FLAGS: [&str; 8] = [
    "--headless",
    "--no-sandbox", // Chromium run as root does not start without it
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
];

/// A browser for tests; without a driver (Playwright's download has none) it can only run the page tests.
pub(crate) struct Browser {
    pub(crate) chrome: PathBuf,
    pub(crate) driver: Option<PathBuf>,
}

/// Returns an installed browser; otherwise installs one from apt (as root on Debian-based systems), or Playwright's
/// download.
pub(crate) fn find() -> Result<Browser> {
    if let Some(browser) = found().or_else(|| apt().and_then(|()| found())) {
        return Ok(browser);
    }
    if let Some(chrome) = playwright() {
        let driver = driver();
        return Ok(Browser { chrome, driver });
    }
    bail!(
        "no browser to test in: install Chromium and its driver \
         (Debian: apt-get install chromium chromium-driver), or set CHROME_PATH and CHROMEDRIVER"
    )
}

/// As [`find`], but if the browser has no driver and apt provides one, installs it.
pub(crate) fn find_with_driver() -> Result<Browser> {
    let browser = find()?;
    let complete = browser.driver.is_some() || std::env::var_os("CHROME_PATH").is_some();
    if complete || apt().is_none() {
        return Ok(browser);
    }
    find()
}

fn found() -> Option<Browser> {
    let chosen = env::var_os("CHROME_PATH").map(PathBuf::from);
    let mac = Some(PathBuf::from(MAC_CHROME)).filter(|path| path.exists());
    let chrome = chosen.or_else(|| on_path(&BROWSERS)).or(mac)?;
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
    let root = || shell::output_of(&mut shell::command("id", &["-u"])).is_some_and(|id| id == "0");
    Path::new("/etc/debian_version").exists() && root()
}

/// Installs Chromium from apt. Fails on Ubuntu, which has no chromium-driver (its chromium is a snap, useless in a
/// container).
fn apt() -> Option<()> {
    install(&["chromium", "chromium-driver", "fonts-liberation"])?;
    // Page tests are faster in the headless shell, and work without it (tests/page/chrome.js).
    let _optional = install(&["chromium-headless-shell"]);
    Some(())
}

/// Installs Debian packages; `None` if that is not possible.
fn install(packages: &[&str]) -> Option<()> {
    if !can_apt() {
        return None;
    }
    println!("installing {} (apt-get)", packages.join(", "));
    let apt = |args: &[&str]| {
        let mut command = shell::command("apt-get", &["-o", APT_WAITS]);
        command.args(args);
        shell::run_quietly(command.env("DEBIAN_FRONTEND", "noninteractive")).ok()
    };
    apt(&["update"])?;
    apt(&[&["install", "-y", "--no-install-recommends"], packages].concat())
}

/// The path of Firefox, which is installed from apt if necessary.
pub(crate) fn firefox() -> Option<PathBuf> {
    let chosen = || env::var_os("FIREFOX_PATH").map(PathBuf::from);
    let mac = || Some(PathBuf::from(MAC_FIREFOX)).filter(|path| path.exists());
    let found = || {
        chosen()
            .or_else(|| on_path(&FIREFOXES))
            .or_else(mac)
            .filter(|_| has_screen())
    };
    found().or_else(|| install(&["firefox-esr", "xvfb"]).and_then(|()| found()))
}

/// The path of the WebKitGTK driver, which includes a browser; installed from apt if necessary.
pub(crate) fn webkit() -> Option<PathBuf> {
    let chosen = || env::var_os("WEBKIT_DRIVER").map(PathBuf::from);
    let found = || {
        chosen()
            .or_else(|| on_path(&["WebKitWebDriver"]))
            .filter(|_| has_screen())
    };
    found().or_else(|| install(&["webkit2gtk-driver", "xvfb"]).and_then(|()| found()))
}

/// Whether an X server is available, possibly a virtual one; on Linux, Firefox and WebKitGTK need it.
fn has_screen() -> bool {
    !cfg!(target_os = "linux") || env::var_os("DISPLAY").is_some() || on_path(&["Xvfb"]).is_some()
}

/// Downloads the Chromium version of the pinned playwright-core and returns its path.
fn playwright() -> Option<PathBuf> {
    println!("downloading Chromium (playwright)");
    let mut install = shell::node(&["node_modules/playwright-core/cli.js", "install", "chromium"]);
    if can_apt() {
        install.arg("--with-deps"); // the shared libraries that Chromium needs
    }
    shell::run(&mut install).ok()?;
    let ask = "import('playwright-core').then(p => console.log(p.chromium.executablePath()))";
    let path = PathBuf::from(shell::output_of(&mut shell::node(&["-e", ask]))?);
    path.is_file().then_some(path)
}

/// The settings file that wasm-bindgen's test runner passes to the driver.
pub(crate) fn driver_settings(browser: &Browser) -> Result<PathBuf> {
    let path = shell::target_dir().join("webdriver.json");
    let chrome = browser.chrome.to_string_lossy();
    let json =
        format!("{{\"goog:chromeOptions\": {{\"binary\": {chrome:?}, \"args\": {FLAGS:?}}}}}\n");
    fs::write(&path, json)?;
    Ok(path)
}
