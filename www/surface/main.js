// The page is the two elements; this defines them.
import "casteljau/elements";
