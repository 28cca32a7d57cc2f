// The scripts of the first page: the word at once, the other pictures when they are almost visible.
import "../parts/header.js";
import "./tabs.js";
import "./word-figure.js";
import { find } from "./picture.js";

/** The figure of the former first page, with what a reader has changed in it, is on the page of elements. */
if (/^#hero\b/.test(location.hash)) location.replace(`elements/${location.hash}`);

const MARGIN = "300px";
const gallery = new IntersectionObserver(
  (entries) => {
    if (!entries.at(-1)?.isIntersecting) return;
    gallery.disconnect();
    void import("./gallery.js");
  },
  { rootMargin: MARGIN },
);
gallery.observe(find(".gallery"));

find("#measure").addEventListener("click", async () => {
  const { measure } = await import("./measure.js");
  await measure(find("#measure"), find("#measured"));
});
