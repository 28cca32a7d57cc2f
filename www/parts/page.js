// The scripts of a chapter: the list of sections, the figures, the tasks and samples, and the address with the elements.
import "./contents.js";
import "./figures.js";
import "./full-screen.js";
import "./lesson-progress.js";
import "./lesson-sample.js";
import "./lesson-task.js";
import "./url-state.js";
