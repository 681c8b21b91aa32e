# Everything that the page of reports is made from, beside this file.
set(web_sources
  package.json package-lock.json .npmrc bundle.mjs
  src/page.html src/style.css src/main.js
  src/data.js src/dom.js src/units.js src/colours.js
  src/facts.js src/charts.js src/chart_list.js
  src/viewer.js src/scene.js src/wall.js src/flow.js src/lumen.js src/section.js src/player.js)
