// The scripts of a chapter: the elements, the parts, the list of sections, and the address.
import "./contents.js";
import "./elements.js";
import "./figures.js";
import "./full-screen.js";
import "./lesson-progress.js";
import "./lesson-sample.js";
import "./lesson-task.js";
import "./url-state.js";
