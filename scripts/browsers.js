// Finding browsers for tests, or installing them from apt (as root on Debian and its relatives).
import { existsSync } from "node:fs";
import { delimiter, join } from "node:path";
import { alone, run, say } from "./run.js";

/** A step cannot run on this machine; the message says why. */
export class Skipped extends Error {}

/** @param {string[]} names */
const onPath = (names) =>
  names
    .flatMap((name) => (process.env.PATH ?? "").split(delimiter).map((folder) => join(folder, name)))
    .find((path) => existsSync(path));

/** @param {string} path */
const ifExists = (path) => (existsSync(path) ? path : undefined);

/** On Linux, Firefox and WebKitGTK need an X server, possibly a virtual one. */
const hasScreen = () =>
  process.platform !== "linux" || process.env.DISPLAY !== undefined || onPath(["Xvfb"]) !== undefined;

/** What can be looked for: where it is found, the arguments of apt-get install, and the variable that can name its path. */
const PROGRAMS = {
  chromium: {
    variable: "CHROME_PATH",
    find: () =>
      onPath(["chromium-headless-shell", "chromium", "chromium-browser", "google-chrome", "google-chrome-stable"]) ??
      ifExists("/Applications/Google Chrome.app/Contents/MacOS/Google Chrome"),
    install: ["--no-install-recommends", "chromium-headless-shell", "fonts-liberation"],
  },
  chromedriver: {
    variable: "CHROMEDRIVER",
    find: () =>
      onPath(["chromium", "chromium-browser", "google-chrome"]) && onPath(["chromedriver", "chromium.chromedriver"]),
    install: ["--no-install-recommends", "chromium", "chromium-driver"],
  },
  firefox: {
    variable: "FIREFOX_PATH",
    find: () => {
      const path = onPath(["firefox-esr", "firefox"]) ?? ifExists("/Applications/Firefox.app/Contents/MacOS/firefox");
      return hasScreen() ? path : undefined;
    },
    install: ["firefox-esr", "xvfb"],
  },
  webkit: {
    variable: "WEBKIT_DRIVER",
    find: () => (hasScreen() ? onPath(["WebKitWebDriver"]) : undefined),
    install: ["webkit2gtk-driver", "xvfb"],
  },
};

/**
 * The variable and the path of a browser or a driver, which is installed if that is possible.
 *
 * @param {keyof typeof PROGRAMS} name
 * @returns {Promise<Record<string, string>>}
 */
export async function browser(name) {
  const { variable, find, install } = PROGRAMS[name];
  let path = process.env[variable] ?? find();
  if (!path && canInstall()) {
    await apt(install);
    path = find();
  }
  if (path) return { [variable]: path };
  throw new Skipped(`no ${name}: apt-get install ${install.join(" ")}, or set ${variable} to its path`);
}

const canInstall = () => process.getuid?.() === 0 && onPath(["apt-get"]) !== undefined;

/** @param {string[]} packages */
const apt = (packages) =>
  alone("apt", async () => {
    say(`installing ${packages.join(", ")} (apt-get)`);
    const options = ["-o", "DPkg::Lock::Timeout=120", "-qq"];
    const env = { DEBIAN_FRONTEND: "noninteractive" };
    await run("apt-get", [...options, "update"], { env });
    await run("apt-get", [...options, "install", "-y", ...packages], { env });
  }).catch((error) => say(error.message));
