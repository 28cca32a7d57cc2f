// The page of a chapter: its contents. A place in the chapter, `#figure-hull`, is on the page of a section, which the server cannot know.
import "./lesson-progress.js";

function forward() {
  const id = decodeURIComponent(location.hash.slice(1).split("?")[0]);
  const page = /** @type {HTMLElement | null} */ (document.getElementById(id)?.closest("[data-page]"))?.dataset.page;
  // A section's own id is the top of its page.
  if (page) location.replace(page === `${id}/` && !location.hash.includes("?") ? page : page + location.hash);
}

addEventListener("hashchange", forward);
forward();
