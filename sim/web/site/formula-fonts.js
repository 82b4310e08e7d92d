// Asks for the fonts of formulas before there is any text: they lie within the style sheet, and are there
// with the first picture, so that no line moves when they come.

for (const face of ["KaTeX_Main", "KaTeX_Size1", "KaTeX_Size2", "KaTeX_Size3", "KaTeX_Size4"]) {
  void document.fonts.load(`1em ${face}`);
}
void document.fonts.load("italic 1em KaTeX_Math");
