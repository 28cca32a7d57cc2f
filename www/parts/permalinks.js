// A link to itself at every section, entry and figure that has an id: what is shown can be sent to someone.
import { element } from "./dom.js";

/** @param {Element} place where the link goes @param {string} id @param {string} words */
function link(place, id, words) {
  const made = element("a", { className: "permalink", textContent: "#" });
  made.setAttribute("href", `#${id}`);
  made.setAttribute("aria-label", words);
  place.append(made);
}

for (const section of document.querySelectorAll("main > section[id]")) {
  const heading = section.querySelector(":scope > h2");
  if (heading) link(heading, section.id, "Link to this section");
}
for (const article of document.querySelectorAll("main article[id]")) {
  const heading = article.querySelector(":scope > h3");
  if (heading) link(heading, article.id, "Link to this entry");
}
for (const figure of document.querySelectorAll("main figure[id]")) {
  const caption = figure.querySelector(":scope > figcaption");
  if (caption) link(caption, figure.id, "Link to this figure");
}
