"""Settings of Sphinx for the pages that docs/tools/make_site.py prepares."""
project = "TinyDEM"
html_title = "TinyDEM, teaching edition"
author = copyright = "the TinyDEM teaching edition authors"
extensions = ["myst_parser", "sphinx.ext.mathjax"]
exclude_patterns = ["conf.py"]

myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4  # the anchors of GitHub
myst_update_mathjax = False

html_theme = "furo"
html_static_path = ["_static"]
html_css_files = ["tinydem.css"]
html_show_sphinx = html_copy_source = html_show_sourcelink = False
html_theme_options = {"light_css_variables": {"color-brand-primary": "#1f5a8a",
                                              "color-brand-content": "#1f5a8a"}}

# Formulas are drawn in the browser by MathJax, which is part of the site; as SVG, because that
# needs no font files, and so works for pages opened from the disk.
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_SVG-full"
mathjax2_config = {"tex2jax": {"inlineMath": [["\\(", "\\)"]], "displayMath": [["\\[", "\\]"]],
                               "ignoreClass": "document", "processClass": "math"},
                   "menuSettings": {"inTabOrder": False}, "showMathMenu": False,
                   "messageStyle": "none"}
