"""How the report looks, on a light and a dark ground and on paper."""

STYLE = """
:root{color-scheme:light dark;--ground:light-dark(#f8f6f1,#151719);--panel:light-dark(#fffefb,#1d1f22);
--line:light-dark(#ddd8cc,#303338);--ink:light-dark(#1a1c1e,#ece9e2);--dim:light-dark(#5c6064,#a6aaae);
--accent:light-dark(#1c5bc7,#80b1ff);--wrong:light-dark(#a83a14,#ff9d77);--soft:light-dark(#fbe9e2,#3a2119);
--c0:light-dark(#0072b2,#56b4e9);--c1:light-dark(#b34e00,#f08a4b);--c2:light-dark(#00795a,#37c79b);
--c3:light-dark(#a8568b,#e39cc4);--c4:light-dark(#8a6b00,#e3c14f);--c5:light-dark(#4d5155,#bcbdbb)}
*{box-sizing:border-box}
body{margin:0 auto;padding:24px 20px 60px;max-width:1060px;background:var(--ground);color:var(--ink);
font:14px/1.5 "Inter","Segoe UI",Roboto,"Noto Sans","DejaVu Sans Condensed",system-ui,sans-serif}
h1{font-size:26px;line-height:1.2;margin:0 0 4px}h2{font-size:19px;margin:36px 0 8px;padding-top:12px;
border-top:1px solid var(--line)}h3{font-size:15px;margin:22px 0 6px}
p{margin:6px 0;max-width:76ch}.dim,figcaption{color:var(--dim)}.wrong{color:var(--wrong)}
ul{margin:6px 0;padding-left:20px}li{max-width:100ch;overflow-wrap:anywhere}
.wide{overflow-x:auto;margin:8px 0}table{border-collapse:collapse;background:var(--panel);font-size:13px}
th,td{padding:4px 10px;border:1px solid var(--line);text-align:right;white-space:nowrap;
font-variant-numeric:tabular-nums}thead th{font-weight:600;white-space:normal;vertical-align:bottom;min-width:64px}
th[scope=row],thead th:first-child{text-align:left;font-weight:600}
tr.removed :is(th,td){color:var(--dim);font-style:italic}
tr.main td{font-weight:600}
figure{margin:12px 0;padding:12px;background:var(--panel);border:1px solid var(--line);border-radius:6px}
figcaption{font-size:12.5px;margin-top:4px}svg{display:block;max-width:100%;height:auto}
svg text{font:12px "Inter","Segoe UI",Roboto,"Noto Sans","DejaVu Sans Condensed",system-ui,sans-serif;fill:var(--ink)}
svg .dim{fill:var(--dim)}svg .axis{stroke:var(--dim);fill:none}svg .grid{stroke:var(--line);fill:none}
@media screen and (max-width:560px){figure{overflow-x:auto}svg{min-width:520px}}
details{margin:8px 0}summary{cursor:pointer;font-weight:600}nav a{margin-right:14px}a{color:var(--accent)}
@media print{:root{color-scheme:light}body{max-width:none;padding:0;font-size:10.5pt;background:#fff}
figure,tr,h2,h3{break-inside:avoid}h2,h3{break-after:avoid}nav{display:none}.wide{overflow:visible}
table{font-size:8pt}th,td{padding:2px 4px}thead th{min-width:0}@page{size:A4 landscape;margin:14mm}}
"""
