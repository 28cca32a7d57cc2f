// The scripts of a section of a chapter.
import "./chapter-bar.js";
import "./figures.js";
import "./full-screen.js";
import "./lesson-progress.js";
import "./lesson-sample.js";
import "./lesson-task.js";
import "./scenes.js";
import "./url-state.js";
