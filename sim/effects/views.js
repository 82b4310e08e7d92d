/** The view of every effect. Written by `make bundle` from the folders beside this file. */

import drag from "./drag/view.js";
import friction from "./friction/view.js";
import incline from "./incline/view.js";
import magnets from "./magnets/view.js";
import push from "./push/view.js";
import release from "./release/view.js";
import spring from "./spring/view.js";

/** @type {Record<string, import("../view/types.js").EffectView>} */
export const VIEWS = {
  drag,
  friction,
  incline,
  magnets,
  push,
  release,
  spring,
};
