// What every lesson's main.js imports: the elements, the parts, and the list of sections.
import "casteljau/elements";
import "./contents.js";
import "./lesson-sample.js";
import "./lesson-task.js";
