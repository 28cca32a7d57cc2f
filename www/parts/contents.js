// The list of sections beside the text: folded on narrow screens, and marking where the reader is.

const WIDE = "(min-width: 75rem)"; // as in site.css

/** @param {HTMLDetailsElement} details */
function fold(details) {
  const wide = matchMedia(WIDE);
  const follow = () => (details.open = wide.matches);
  wide.addEventListener("change", follow);
  follow();
}

/** The last section whose heading has passed the upper third of the window is the one being read. @param {HTMLAnchorElement[]} links */
function mark(links) {
  const targets = links.map((link) => document.getElementById(decodeURIComponent(link.hash.slice(1))));
  const update = () => {
    const line = innerHeight / 3;
    const at = targets.findLastIndex((target) => target && target.getBoundingClientRect().top < line);
    links.forEach((link, i) =>
      i === at ? link.setAttribute("aria-current", "location") : link.removeAttribute("aria-current"),
    );
  };
  let frame = 0;
  const soon = () => {
    if (frame === 0)
      frame = requestAnimationFrame(() => {
        frame = 0;
        update();
      });
  };
  addEventListener("scroll", soon, { passive: true });
  addEventListener("resize", soon);
  update();
}

const contents = document.querySelector(".contents");
const details = contents?.querySelector("details");
if (details) fold(details);
if (contents) mark([...contents.querySelectorAll("a")]);
