// The figure that the query asks for.
import "casteljau/elements";
