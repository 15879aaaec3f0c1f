taut_embed(TARGET taut NAMESPACE taut::report::embedded NAME page_template FILE taut/report/assets/page.html)
taut_embed(TARGET taut NAMESPACE taut::report::embedded NAME page_css FILE taut/report/assets/page.css)
taut_embed(TARGET taut NAMESPACE taut::report::embedded NAME math_font FILE taut/report/assets/taut_math.woff2)
taut_embed(TARGET taut NAMESPACE taut::report::embedded NAME italic_font FILE taut/report/assets/taut_math_italic.woff2)
