// What the page needs is in the parts; this starts them.
import "../parts/page.js";
