// The elements, the sample and the address; the small applet is the classic script's business.
import "./parts/page.js";
