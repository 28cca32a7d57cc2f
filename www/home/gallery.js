// The pictures to try. Two of them run at once: the letter with the module that the word has loaded, and the timing function
// without any. The others are pictures until the reader wants to use them.
import "./things/camera.js";
import "./things/easing.js";
import "./things/glyph.js";
import "./things/ink.js";
import "./things/shapes.js";
import "./things/teapot.js";
