// Texts of the page whose contrast with what lies behind them is below WCAG 2.2 AA: 4.5 to 1, for
// large text 3 to 1. Disabled controls are exempt there and here; pictures (SVG) are not looked at.
() => {
  const LARGE = 24; // px; or 18.66 px and bold
  const parse = (text) => {
    const [r, g, b, alpha = 1] = text.match(/[\d.]+/g).map(Number);
    return { rgb: [r, g, b], alpha };
  };
  const over = (front, back) =>
    front.rgb.map((value, i) => value * front.alpha + back[i] * (1 - front.alpha));
  const luminance = (rgb) => {
    const linear = rgb.map((v) => (v <= 10.31 ? v / 3294.6 : ((v / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
  };
  // Texts have most of what they lie in in common: each element is asked once, for itself and for
  // all that lies in it.
  const once = (find) => {
    const found = new Map();
    const ask = (element) => {
      if (!found.has(element)) found.set(element, find(element, ask));
      return found.get(element);
    };
    return ask;
  };
  const behind = once((element, ask) => {
    const layer = element && parse(getComputedStyle(element).backgroundColor);
    if (!layer) return [255, 255, 255];
    return layer.alpha === 1 ? layer.rgb : over(layer, ask(element.parentElement));
  });
  const opacity = once((element, ask) =>
    element ? Number(getComputedStyle(element).opacity) * ask(element.parentElement) : 1);
  const pale = [];
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (texts.nextNode()) {
    const node = texts.currentNode;
    const element = node.parentElement;
    if (!node.data.trim() || element.closest("script, svg, [hidden], :disabled")) continue;
    const range = document.createRange();
    range.selectNode(node);
    const box = range.getBoundingClientRect();
    const style = getComputedStyle(element);
    const seen = opacity(element);
    if (box.width < 2 || box.height < 2 || style.visibility === "hidden" || seen < 0.05) continue;
    const back = behind(element);
    const ink = parse(style.color);
    const front = over({ rgb: ink.rgb, alpha: ink.alpha * seen }, back);
    const [dark, light] = [luminance(front), luminance(back)].sort((a, b) => a - b);
    const ratio = (light + 0.05) / (dark + 0.05);
    const size = Number.parseFloat(style.fontSize);
    const large = size >= LARGE || (size >= 18.66 && Number(style.fontWeight) >= 700);
    if (ratio < (large ? 3 : 4.5)) pale.push(`${ratio.toFixed(2)}: ${node.data.trim()}`);
  }
  return pale;
}
