// The scripts of a chapter: the elements, the parts, the list of sections, and the address.
import "casteljau/elements";
import "./contents.js";
import "./figures.js";
import "./full-screen.js";
import "./lesson-progress.js";
import "./lesson-sample.js";
import "./lesson-task.js";
import "./url-state.js";
