/*! three 0.185.1

The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
/*! uplot 1.6.32

The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
"use strict";(()=>{function Up(n,e){let t=(i,s)=>`${i.label}/${s}`;for(let i of n){let s=(i.summary.chains??[]).map(o=>o.name),r=n.filter(o=>o===i||s.some(a=>o.label===t(i,a)));if(r.length>1&&r.includes(e))return r.filter(o=>o!==e)}return[]}function Hh({geometry:n}){n&&!n.route.s_m&&(n.route={s_m:[],position_m:[],curvature_per_m:[]})}function Op(n){let e=n.getElementById("hawser-data")?.textContent;if(!e)throw new Error("This page holds no data of a run.");let t=JSON.parse(e);if(t.format!==1)throw new Error(`The data of this page are of format ${String(t.format)}; the page reads 1.`);if(!Array.isArray(t.runs)||t.runs.length===0)throw new Error("The data of this page hold no run.");return t.runs.forEach(Hh),t}var Cy="http://www.w3.org/2000/svg";function Bp(n,e,t){for(let[i,s]of Object.entries(e))typeof s=="function"?n.addEventListener(i.slice(2),s):s===!0?n.setAttribute(i,""):s!==!1&&s!==null&&s!==void 0&&n.setAttribute(i,String(s));for(let i of t)i&&n.append(i)}function P(n,e={},...t){let i=document.createElement(n);return Bp(i,e,t),i}function je(n,e={},...t){let i=document.createElementNS(Cy,n);return Bp(i,e,t),i}var kp=160;function ft(n){let e=String(n??"");return e.length<=kp?P("bdi",{class:"name"},e):P("bdi",{class:"name",title:e.slice(0,2e3)},`${e.slice(0,kp)}\u2026`)}function ei(n,e,t={}){return P("button",{type:"button",onclick:e,...t},n)}var Ry="400px 0px";var Py=new Promise(n=>{setTimeout(n,1500),PerformanceObserver.supportedEntryTypes?.includes("paint")&&new PerformanceObserver(()=>n()).observe({type:"paint",buffered:!0})}),Vp=n=>{"requestIdleCallback"in window?requestIdleCallback(n,{timeout:1500}):setTimeout(n,50)},fa=new Map,zp=new IntersectionObserver(n=>n.forEach(e=>e.isIntersecting&&Gp(e.target)),{rootMargin:Ry}),Wh=!1;function Gp(n){let e=fa.get(n);Hp(n),e?.()}function Hp(n){fa.delete(n),zp.unobserve(n)}function Wp(){let[n]=fa.keys();Wh=n!==void 0,n&&(Gp(n),Vp(Wp))}function Al(n,e){return fa.set(n,e),Py.then(()=>{fa.has(n)&&(zp.observe(n),Wh||(Wh=!0,Vp(Wp)))}),()=>Hp(n)}function Vs(n){let e=new Set;for(let r of n)for(let o of r.x)o!==null&&Number.isFinite(o)&&e.add(o);let t=[...e].sort((r,o)=>r-o),i=new Map(t.map((r,o)=>[r,o])),s=n.map(r=>{let o=new Array(t.length).fill(void 0);return r.x.forEach((a,l)=>{let c=a===null?void 0:i.get(a);c!==void 0&&(o[c]=r.y[l]??null)}),o});return{x:t,y:s}}function Iy(n,e){let t=0,i=n.length;for(;t<i;){let s=t+i>>1;n[s]<=e?t=s+1:i=s}return t-1}function ys(n,e,t){let i=Iy(n,t);for(;i>=0&&e[i]===void 0;)i-=1;if(i<0)return null;let s=e[i];if(s==null)return null;let r=n[i];if(r===t)return s;let o=i+1;for(;o<n.length&&e[o]===void 0;)o+=1;let a=e[o];return a==null?null:s+(a-s)*(t-r)/(n[o]-r)}function Xh(n,e,t){let i=null,s=1/0;return n.forEach((r,o)=>{let a=r===null?1/0:Math.abs(r-t);a<s&&e[o]!==null&&e[o]!==void 0&&(s=a,i=e[o])}),i}function hn(n){let e=1/0,t=-1/0;for(let i of n)i==null||!Number.isFinite(i)||(e=Math.min(e,i),t=Math.max(t,i));return e>t?null:[e,t]}var Cl=4.4482216152605,Ly={N:[{symbol:"kN",factor:.001,from:1e3},{symbol:"N",factor:1,from:0}],"N/m":[{symbol:"kN/m",factor:.001,from:2e3},{symbol:"N/m",factor:1,from:0}],mm:[{symbol:"mm",factor:1e3,from:0}],"N m":[{symbol:"kN m",factor:.001,from:1e4},{symbol:"N m",factor:1,from:0}]},Ny={N:{symbol:"lbf",factor:1/Cl},"N/m":{symbol:"lbf/ft",factor:.3048/Cl},m:{symbol:"ft",factor:1/.3048},mm:{symbol:"in",factor:12/.3048},"m/s":{symbol:"ft/min",factor:60/.3048},"N m":{symbol:"lbf ft",factor:1/(Cl*.3048)},W:{symbol:"ft lbf/s",factor:1/(Cl*.3048)},"1/m":{symbol:"1/ft",factor:.3048}};function kt(n,e,t){let i=Ny[n];if(e==="us"&&i)return i;let r=Ly[n]?.find(({from:o})=>Math.abs(t)>=o);return r?{symbol:r.symbol,factor:r.factor}:{symbol:n==="1"?"":n,factor:1}}function qh(n){let[e="",t]=n.replace("-","\u2212").split("."),s=e.replace(/\D/g,"").length>4?e.replace(/\B(?=(\d{3})+$)/g,"\u202F"):e;return t?`${s}.${t}`:s}function dn(n,e=4){if(n===0)return"0";let t=Math.floor(Math.log10(Math.abs(n)));if(t<-5||t>8)return n.toExponential(e-1);let i=Math.max(0,e-1-t),s=n.toFixed(Math.min(i,12));return qh(s.includes(".")?s.replace(/\.?0+$/,""):s)}var ai="not known";function Qe(n,e,t,i=4){if(n==null||Number.isNaN(n))return ai;if(e==="%")return`${dn(n,i)}\u202F%`;let{symbol:s,factor:r}=kt(e,t,n);return s?`${dn(n*r,i)}\xA0${s}`:dn(n*r,i)}function Rl(n){return["N","N/m","m","mm","m/s","s","1","%","N m","W","rad/s","1/m"].includes(n)}var Dy=/(-?\d+(?:\.\d+)?(?:e[+-]?\d+)?)\s(kN\/m|N\/m|m\/s|kN m|N m|kN|mm|N|m)(?![\w/])/g,Fy={"kN/m":["N/m",1e3],"kN m":["N m",1e3],kN:["N",1e3],mm:["mm",.001]};function kn(n,e){if(e==="si")return n;let t=(i,s,r)=>{let[o,a]=Fy[r]??[r,1];return Qe(Number(s)*a,o,e)};return n.split(/('[^']*')/).map((i,s)=>s%2===1?i:i.replace(Dy,t)).join("")}var Uy={text:"#1b1f24",muted:"#57606a",grid:"#e3e7eb",paper:"#ffffff",limit:"#c04a00",event:"#7a5195",window:"rgba(0, 114, 178, 0.07)",band:"rgba(0, 114, 178, 0.16)",curve:{simulated:"#0072b2",peak:"#0072b2",envelope:"#5aa9d6",theory:"#1b1f24",backward:"#8a6d00",paper:"#b3437c",second:"#c98a00",third:"#007f5f",fourth:"#b3437c",fifth:"#3f8fc0",sixth:"#57606a",ground:"#57606a",route:"#1b1f24"}},Oy={text:"#e6eaee",muted:"#9aa5b1",grid:"#2b323a",paper:"#161b21",limit:"#ff8a4c",event:"#c3a1dd",window:"rgba(86, 180, 233, 0.09)",band:"rgba(86, 180, 233, 0.22)",curve:{simulated:"#56b4e9",peak:"#56b4e9",envelope:"#3b7ea8",theory:"#e6eaee",backward:"#d9bf4d",paper:"#e39ac4",second:"#e69f00",third:"#2fc59a",fourth:"#e39ac4",fifth:"#8fc7ea",sixth:"#9aa5b1",ground:"#9aa5b1",route:"#e6eaee"}},zi=n=>n==="dark"?Oy:Uy,oo={simulated:[],peak:[1,3],envelope:[],theory:[7,4],backward:[2,3],paper:[9,3,2,3],second:[6,3],third:[2,2],fourth:[9,3,2,3],fifth:[12,4],sixth:[4,2,1,2],ground:[],route:[]},ao={simulated:2,peak:1.5,envelope:1,theory:1.5,backward:1.5,paper:1.5,second:1.5,third:1.5,fourth:1.5,fifth:1.5,sixth:1.5,ground:1.5,route:1.5},zs=["simulated","second","third","fourth","fifth","sixth"];var ky=2.5;function Sr(n){let e=Math.max(0,...n.curves.map(t=>hn(t.y)?.[1]??0));return(n.levels??[]).filter(({value:t})=>t<=ky*e||e===0)}function Pl(n,e,t){let i=[e,t,...Sr(n).map(({value:l})=>l),...n.fromZero===!1?[]:[0]],s=Math.max(0,(n.span??0)-(Math.max(...i)-Math.min(...i)))/2,[r,o]=[Math.min(...i)-s,Math.max(...i)+s],a=(o-r||Math.abs(o)||1)*.06;return[r===0?0:r-a,o===0&&r<0?0:o+a]}function Xp(n,e,t,i){let s=(o,a)=>n.x[a]>=e&&n.x[a]<=t,r=n.y.flatMap((o,a)=>i.has(a)?[]:hn(o.filter(s))??[]);return hn(r)??[0,1]}function lo(n,e,t){let i=e-n;if(!(i>0))return[n];let s=i/Math.max(1,t),r=10**Math.floor(Math.log10(s)),o=[1,2,5,10].map(l=>l*r).find(l=>l>=s*.999)??s,a=[];for(let l=Math.ceil(n/o-1e-9);l*o<=e+1e-9*i;l+=1)a.push(l*o);return a}function pa(n){let e=n.length>1?Math.abs(n[1]-n[0]):1,t=Math.max(0,Math.min(8,-Math.floor(Math.log10(e)+1e-9)));return n.map(i=>qh(Math.abs(i)<e*1e-6?"0":i.toFixed(t)))}var Il={place:"m",time:"s",head:"m"};function By(n,e){let t=zi(e).curve[n.role],i=n.points?je("circle",{cx:13,cy:6,r:3,fill:zi(e).paper,stroke:t,"stroke-width":1.5}):je("path",{d:"M1 6H25",stroke:t,"stroke-width":ao[n.role],"stroke-dasharray":oo[n.role].join(" ")||null});return je("svg",{width:26,height:12,"aria-hidden":"true",class:"swatch"},i)}function qp(n){return je("svg",{width:26,height:12,"aria-hidden":"true",class:"swatch"},je("rect",{x:2,y:1,width:22,height:10,fill:n}))}function Vy(n){return je("svg",{width:26,height:12,"aria-hidden":"true",class:"swatch"},je("path",{d:"M1 6H25",stroke:n,"stroke-width":2}))}function $p(n,e,t,i){let s=zi(i.theme),r=P("span",{class:"legend-at"}),o=[],a=P("ul",{class:"legend","aria-label":"Curves"});n.curves.forEach((u,d)=>{if(u.quiet){o.push(null);return}let h=P("span",{class:"legend-value"});o.push(h);let f=!i.hidden.has(d),p=P("button",{type:"button",class:"legend-item","aria-pressed":String(f),onclick:()=>i.onToggle(d)},By(u,i.theme),P("bdi",{},u.label));a.append(P("li",{},p,h))}),n.band&&a.append(P("li",{},P("span",{class:"legend-item"},qp(s.band),n.band.label)));let l=new Set(Sr(n));for(let u of n.levels??[]){let d=l.has(u)?"":" (above the figure)",h=`${u.label}: ${Qe(u.value,n.yUnit,i.units)}${d}`;a.append(P("li",{},P("span",{class:"legend-item"},Vy(s.limit),h)))}n.window&&a.append(P("li",{},P("span",{class:"legend-item"},qp(s.window),n.window.label)));let c="";return{element:P("div",{class:"legend-row"},a,r),update(u){let d=[];n.curves.forEach((h,f)=>{let p=u===null?null:ys(e.x,e.y[f]??[],u),v=p===null?"":`${dn(p*t.factor)}\xA0${t.symbol}`.trim(),g=o[f];g&&(g.textContent=v),v&&g&&d.push(`${h.label} ${v}`)}),r.textContent=u===null?"":`at ${Qe(u,Il[n.along],i.units)}`,c=u===null?"":`${r.textContent}: ${d.join(", ")||"nothing known"}`},sentence:()=>c}}function Ll(n,e){if(n.along==="place")return e.get("place");let t=e.get("time");return n.along==="time"||t===null?t:n.clock?Xh(n.clock.time,n.clock.head,t):null}function Yh(n,e,t,i){if(n.along==="place")e.set("place",t,i);else if(t!==null&&n.along==="time")e.set("time",t,i);else if(n.along==="head"){e.set("place",t,i);let s=t===null||!n.clock?null:Xh(n.clock.head,n.clock.time,t);s!==null&&e.set("time",s,i)}}function Yp(n,e){let{chart:t,xScale:i}=n,s=e===null?-10:t.valToPos(e*i.factor,"x"),r=s>=0&&s<=t.over.clientWidth;t.setCursor({left:r?s:-10,top:r?10:-10},!1)}function $h(n,e,t,i){let s=Math.max(e[0],t-(t-n[0])*i),r=Math.min(e[1],t+(n[1]-t)*i);return r-s<(e[1]-e[0])*1e-4?n:[s,r]}function Zp(n,e){if(n.ctrlKey||n.metaKey||n.altKey)return;let t=e.view(),i=e.cursor()??(t[0]+t[1])/2,s=(t[1]-t[0])/100*(n.shiftKey?10:1),r=l=>Math.min(t[1],Math.max(t[0],l)),a={ArrowLeft:()=>e.move(r(i-s)),ArrowRight:()=>e.move(r(i+s)),Home:()=>e.move(t[0]),End:()=>e.move(t[1]),"+":()=>e.zoom($h(t,e.reach(),r(i),.5)),"=":()=>e.zoom($h(t,e.reach(),r(i),.5)),"-":()=>e.zoom($h(t,e.reach(),r(i),2)),0:()=>e.zoom(e.reach())}[n.key];a&&(n.preventDefault(),a())}var zy="uplot",Gy="u-hz",Hy="u-vt",Wy="u-title",Xy="u-wrap",qy="u-under",$y="u-over",Yy="u-axis",Er="u-off",Zy="u-select",Ky="u-cursor-x",Jy="u-cursor-y",jy="u-cursor-pt",Qy="u-legend",ev="u-live",tv="u-inline",nv="u-series",iv="u-marker",Kp="u-label",sv="u-value",ga="width",_a="height";var Jp="bottom",co="left",Zh="right",dd="#000",jp=dd+"0",Kh="mousemove",Qp="mousedown",Jh="mouseup",em="mouseenter",tm="mouseleave",nm="dblclick",rv="resize",ov="scroll",im="change",Ol="dppxchange",fd="--",_o=typeof window<"u",nd=_o?document:null,ho=_o?window:null,av=_o?navigator:null,Ct,Nl;function id(){let n=devicePixelRatio;Ct!=n&&(Ct=n,Nl&&rd(im,Nl,id),Nl=matchMedia(`(min-resolution: ${Ct-.001}dppx) and (max-resolution: ${Ct+.001}dppx)`),Ar(im,Nl,id),ho.dispatchEvent(new CustomEvent(Ol)))}function xi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function sd(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Jt(n,e,t){n.style[e]=t+"px"}function Gi(n,e,t,i){let s=nd.createElement(n);return e!=null&&xi(s,e),t?.insertBefore(s,i),s}function Li(n,e){return Gi("div",n,e)}var sm=new WeakMap;function os(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=sm.get(n);r!=o&&(n.style.transform=r,sm.set(n,r),e<0||t<0||e>i||t>s?xi(n,Er):sd(n,Er))}var rm=new WeakMap;function om(n,e,t){let i=e+t,s=rm.get(n);i!=s&&(rm.set(n,i),n.style.background=e,n.style.borderColor=t)}var am=new WeakMap;function lm(n,e,t,i){let s=e+""+t,r=am.get(n);s!=r&&(am.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var pd={passive:!0},lv={...pd,capture:!0};function Ar(n,e,t,i){e.addEventListener(n,t,i?lv:pd)}function rd(n,e,t,i){e.removeEventListener(n,t,pd)}_o&&id();function Hi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:yi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function Um(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var Om=n=>n!=null,km=n=>n!=null&&n>0,Vl=Um(Om),cv=Um(km);function uv(n,e,t,i=0,s=!1){let r=s?cv:Vl,o=s?km:Om;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Wt,l??-Wt]}function zl(n,e,t,i){let s=hm(n),r=hm(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?vs:Bm,a=s==1?yi:Ni,l=r==1?Ni:yi,c=a(o(Sn(n))),u=l(o(Sn(e))),d=fo(t,c),h=fo(t,u);return t==10&&(c<0&&(d=Xt(d,-c)),u<0&&(h=Xt(h,-u))),i||t==2?(n=d*s,e=h*r):(n=Hm(n,d),e=Gl(e,h)),[n,e]}function md(n,e,t,i){let s=zl(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var gd=.1,cm={mode:3,pad:gd},ya={pad:0,soft:null,mode:0},hv={min:ya,max:ya};function kl(n,e,t,i){return Hl(t)?um(n,e,t):(ya.pad=t,ya.soft=i?0:null,ya.mode=i?3:0,um(n,e,hv))}function St(n,e){return n??e}function dv(n,e,t){for(e=St(e,0),t=St(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function um(n,e,t){let i=t.min,s=t.max,r=St(i.pad,0),o=St(s.pad,0),a=St(i.hard,-Wt),l=St(s.hard,Wt),c=St(i.soft,Wt),u=St(s.soft,-Wt),d=St(i.mode,0),h=St(s.mode,0),f=e-n,p=vs(f),v=ti(Sn(n),Sn(e)),g=vs(v),m=Sn(g-p);(f<1e-24||m>10)&&(f=0,(n==0||e==0)&&(f=1e-24,d==2&&c!=Wt&&(r=0),h==2&&u!=-Wt&&(o=0)));let S=f||v||1e3,A=vs(S),b=fo(10,yi(A)),C=S*(f==0?n==0?.1:1:r),T=Xt(Hm(n-C,b/10),24),N=n>=c&&(d==1||d==3&&T<=c||d==2&&T>=c)?c:Wt,y=ti(a,T<N&&n>=N?N:Wi(N,T)),E=S*(f==0?e==0?.1:1:o),F=Xt(Gl(e+E,b/10),24),I=e<=u&&(h==1||h==3&&F>=u||h==2&&F<=u)?u:-Wt,U=Wi(l,F>I&&e<=I?I:ti(I,F));return y==U&&y==0&&(U=100),[y,U]}var fv=new Intl.NumberFormat(_o?av.language:"en-US"),_d=n=>fv.format(n),vi=Math,Ul=vi.PI,Sn=vi.abs,yi=vi.floor,Mn=vi.round,Ni=vi.ceil,Wi=vi.min,ti=vi.max,fo=vi.pow,hm=vi.sign,vs=vi.log10,Bm=vi.log2,pv=(n,e=1)=>vi.sinh(n)*e,jh=(n,e=1)=>vi.asinh(n/e),Wt=1/0;function dm(n){return(vs((n^n>>31)-(n>>31))|0)+1}function od(n,e,t){return Wi(ti(n,e),t)}function Vm(n){return typeof n=="function"}function gt(n){return Vm(n)?n:()=>n}var mv=()=>{},zm=n=>n,Gm=(n,e)=>e,gv=n=>null,fm=n=>!0,pm=(n,e)=>n==e,_v=/\.\d*?(?=9{6,}|0{6,})/gm,Cr=n=>{if(Xm(n)||Hs.has(n))return n;let e=`${n}`,t=e.match(_v);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Cr(s)}e${r}`}return Xt(n,i)};function wr(n,e){return Cr(Xt(Cr(n/e))*e)}function Gl(n,e){return Cr(Ni(Cr(n/e))*e)}function Hm(n,e){return Cr(yi(Cr(n/e))*e)}function Xt(n,e=0){if(Xm(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Mn(i)/t}var Hs=new Map;function Wm(n){return((""+n).split(".")[1]||"").length}function ba(n,e,t,i){let s=[],r=i.map(Wm);for(let o=e;o<t;o++){let a=Sn(o),l=Xt(fo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:Xt(u,d);s.push(h),Hs.set(h,d)}}return s}var va={},xd=[],po=[null,null],Gs=Array.isArray,Xm=Number.isInteger,xv=n=>n===void 0;function mm(n){return typeof n=="string"}function Hl(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function yv(n){return n!=null&&typeof n=="object"}var vv=Object.getPrototypeOf(Uint8Array),qm="__proto__";function mo(n,e=Hl){let t;if(Gs(n)){let i=n.find(s=>s!=null);if(Gs(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=mo(n[s],e)}else t=n.slice()}else if(n instanceof vv)t=n.slice();else if(e(n)){t={};for(let i in n)i!=qm&&(t[i]=mo(n[i],e))}else t=n;return t}function _n(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=qm&&(Hl(n[s])?_n(n[s],mo(i[s])):n[s]=mo(i[s]))}return n}var bv=0,Mv=1,Sv=2;function wv(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function Tv(n,e){if(Cv(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Rv(o[0])||(o=Av(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],d=Array(s).fill(void 0),h=e?e[o][c]:Mv,f=[];for(let p=0;p<u.length;p++){let v=u[p],g=r.get(l[p]);v===null?h!=bv&&(d[g]=v,h==Sv&&f.push(g)):d[g]=v}wv(d,f,s),i.push(d)}}return i}var Ev=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Av(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function Cv(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Rv(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=ti(1,yi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var $m=["January","February","March","April","May","June","July","August","September","October","November","December"],Ym=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Zm(n){return n.slice(0,3)}var Pv=Ym.map(Zm),Iv=$m.map(Zm),Lv={MMMM:$m,MMM:Iv,WWWW:Ym,WWW:Pv};function ma(n){return(n<10?"0":"")+n}function Nv(n){return(n<10?"00":n<100?"0":"")+n}var Dv={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>ma(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ma(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>ma(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ma(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ma(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Nv(n.getMilliseconds())};function yd(n,e){e=e||Lv;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?Dv[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var Fv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Uv(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==Fv?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var Km=n=>n%1==0,Bl=[1,2,2.5,5],Ov=ba(10,-32,0,Bl),Jm=ba(10,0,32,Bl),kv=Jm.filter(Km),Tr=Ov.concat(Jm),vd=`
`,jm="{YYYY}",gm=vd+jm,Qm="{M}/{D}",xa=vd+Qm,Dl=xa+"/{YY}",eg="{aa}",Bv="{h}:{mm}",uo=Bv+eg,_m=vd+uo,xm=":{ss}",It=null;function tg(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?ba(10,0,3,Bl).filter(Km):ba(10,-3,0,Bl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,jm,It,It,It,It,It,It,1],[s*28,"{MMM}",gm,It,It,It,It,It,1],[s,Qm,gm,It,It,It,It,It,1],[i,"{h}"+eg,Dl,It,xa,It,It,It,1],[t,uo,Dl,It,xa,It,It,It,1],[e,xm,Dl+" "+uo,It,xa+" "+uo,It,_m,It,1],[n,xm+".{fff}",Dl+" "+uo,It,xa+" "+uo,It,_m,It,1]];function u(d){return(h,f,p,v,g,m)=>{let S=[],A=g>=o,b=g>=r&&g<o,C=d(p),T=Xt(C*n,3),N=Qh(C.getFullYear(),A?0:C.getMonth(),b||A?1:C.getDate()),y=Xt(N*n,3);if(b||A){let E=b?g/r:0,F=A?g/o:0,I=T==y?T:Xt(Qh(N.getFullYear()+F,N.getMonth()+E,1)*n,3),U=new Date(Mn(I/n)),k=U.getFullYear(),X=U.getMonth();for(let O=0;I<=v;O++){let $=Qh(k+F*O,X+E*O,1),H=$-d(Xt($*n,3));I=Xt((+$+H)*n,3),I<=v&&S.push(I)}}else{let E=g>=s?s:g,F=yi(p)-yi(T),I=y+F+Gl(T-y,E);S.push(I);let U=d(I),k=U.getHours()+U.getMinutes()/t+U.getSeconds()/i,X=g/i,O=h.axes[f]._space,$=m/O;for(;I=Xt(I+g,n==1?0:3),!(I>v);)if(X>1){let H=yi(Xt(k+X,6))%24,le=d(I).getHours()-H;le>1&&(le=-1),I-=le*i,k=(k+X)%24;let de=S[S.length-1];Xt((I-de)/g,3)*$>=.7&&S.push(I)}else S.push(I)}return S}}return[l,c,u]}var[Vv,zv,Gv]=tg(1),[Hv,Wv,Xv]=tg(.001);ba(2,-53,53,[1]);function ym(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function vm(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,u,d,h,f;return i.map(p=>{let v=n(p),g=v.getFullYear(),m=v.getMonth(),S=v.getDate(),A=v.getHours(),b=v.getMinutes(),C=v.getSeconds(),T=g!=l&&a[2]||m!=c&&a[3]||S!=u&&a[4]||A!=d&&a[5]||b!=h&&a[6]||C!=f&&a[7]||a[1];return l=g,c=m,u=S,d=A,h=b,f=C,T(v)})}}function qv(n,e){let t=yd(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Qh(n,e,t){return new Date(n,e,t)}function bm(n,e){return e(n)}var $v="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Mm(n,e){return(t,i,s,r)=>r==null?fd:e(n(i))}function Yv(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function Zv(n,e){return n.series[e].fill(n,e)}var Kv={show:!0,live:!0,isolate:!1,mount:mv,markers:{show:!0,width:2,stroke:Yv,fill:Zv,dash:"solid"},idx:null,idxs:null,values:[]};function Jv(n,e){let t=n.cursor.points,i=Li(),s=t.size(n,e);Jt(i,ga,s),Jt(i,_a,s);let r=s/-2;Jt(i,"marginLeft",r),Jt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Jt(i,"borderWidth",o),i}function jv(n,e){let t=n.series[e].points;return t._fill||t._stroke}function Qv(n,e){let t=n.series[e].points;return t._stroke||t._fill}function eb(n,e){return n.series[e].points.size}var ed=[0,0];function tb(n,e,t){return ed[0]=e,ed[1]=t,ed}function Fl(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function td(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var nb={show:!0,x:!0,y:!0,lock:!1,move:tb,points:{one:!1,show:Jv,size:eb,width:0,stroke:Qv,fill:jv},bind:{mousedown:Fl,mouseup:Fl,click:Fl,dblclick:Fl,mousemove:td,mouseleave:td,mouseenter:td},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},ng={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},bd=_n({},ng,{filter:Gm}),ig=_n({},bd,{size:10}),sg=_n({},ng,{show:!1}),Md='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',rg="bold "+Md,og=1.5,Sm={show:!0,scale:"x",stroke:dd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:rg,side:2,grid:bd,ticks:ig,border:sg,font:Md,lineGap:og,rotate:0},ib="Value",sb="Time",wm={show:!0,scale:"x",auto:!1,sorted:1,min:Wt,max:-Wt,idxs:[]};function rb(n,e,t,i,s){return e.map(r=>r==null?"":_d(r))}function ob(n,e,t,i,s,r,o){let a=[],l=Hs.get(s)||0;t=o?t:Xt(Gl(t,s),l);for(let c=t;c<=i;c=Xt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function ad(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?vs:Bm,u=yi(c(t));s=fo(l,u),l==10&&(s=Tr[Hi(s,Tr)]);let d=t,h=s*l;l==10&&(h=Tr[Hi(h,Tr)]);do a.push(d),d=d+s,l==10&&!Hs.has(d)&&(d=Xt(d,Hs.get(s))),d>=h&&(s=d,h=s*l,l==10&&(h=Tr[Hi(h,Tr)]));while(d<=i);return a}function ab(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?ad(n,e,ti(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?ad(n,e,ti(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var ag=/./,lb=/[12357]/,cb=/[125]/,Tm=/1/,ld=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function ub(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),d=l(9,o)-u>=c?ag:l(7,o)-u>=c?lb:l(5,o)-u>=c?cb:Tm;if(d==Tm){let h=Sn(l(1,o)-u);if(h<c)return ld(e.slice().reverse(),a.distr,d,Ni(c/h)).reverse()}return ld(e,a.distr,d,1)}function hb(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=Sn(l(1,o)-l(2,o));return c<a?ld(e.slice().reverse(),3,ag,Ni(a/c)).reverse():e}function db(n,e,t,i){return i==null?fd:e==null?"":_d(e)}var Em={show:!0,scale:"y",stroke:dd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:rg,side:3,grid:bd,ticks:ig,border:sg,font:Md,lineGap:og,rotate:0};function fb(n,e){let t=3+(n||1)*2;return Xt(t*e,3)}function pb(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=Sn(o-r),l=n.series[e],c=a/(l.points.space*Ct);return i[1]-i[0]<=c}var Am={scale:null,auto:!0,sorted:0,min:Wt,max:-Wt},lg=(n,e,t,i,s)=>s,Cm={show:!0,auto:!0,sorted:0,gaps:lg,alpha:1,facets:[_n({},Am,{scale:"x"}),_n({},Am,{scale:"y"})]},Rm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:lg,alpha:1,points:{show:pb,filter:null},values:null,min:Wt,max:-Wt,idxs:[],path:null,clip:null};function mb(n,e,t,i,s){return t/10}var cg={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},gb=_n({},cg,{time:!1,ori:1}),Pm={};function ug(n,e){let t=Pm[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Pm[n]=t)),t}var go=1,cd=2;function Rr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],d=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,f=a.top,p=a.width,v=a.height,g=n.valToPosH,m=n.valToPosV;return u.ori==0?t(s,l,c,u,d,g,m,h,f,p,v,Xl,xo,$l,dg,pg):t(s,l,c,u,d,m,g,f,h,v,p,ql,yo,Td,fg,mg)}function Sd(n,e){let t=0,i=0,s=St(n.bands,xd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function _b(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function bs(n,e,t,i,s,r){return Rr(n,e,(o,a,l,c,u,d,h,f,p,v,g)=>{let m=o.pxRound,S=c.dir*(c.ori==0?1:-1),A=c.ori==0?xo:yo,b,C;S==1?(b=t,C=i):(b=i,C=t);let T=m(d(a[b],c,v,f)),N=m(h(l[b],u,g,p)),y=m(d(a[C],c,v,f)),E=m(h(r==1?u.max:u.min,u,g,p)),F=new Path2D(s);return A(F,y,E),A(F,T,E),A(F,T,N),F})}function Wl(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?$l:Td,l=t;for(let d=0;d<n.length;d++){let h=n[d];if(h[1]>h[0]){let f=h[0]-l;f>0&&a(o,l,i,f,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function xb(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function wd(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let d=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let f=r(n[d]),p=h==d?f:r(n[h]),v=d-s;f=o<=0&&v>=0&&v<l?r(n[v]):f;let m=h+s;p=o>=0&&m>=0&&m<l?r(n[m]):p,p>=f&&a.push([f,p])}return a}function Im(n){return n==0?zm:n==1?Mn:e=>wr(e,n)}function hg(n){let e=n==0?Xl:ql,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Wi(c,a/2,l/2),u=Wi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Xl=(n,e,t)=>{n.moveTo(e,t)},ql=(n,e,t)=>{n.moveTo(t,e)},xo=(n,e,t)=>{n.lineTo(e,t)},yo=(n,e,t)=>{n.lineTo(t,e)},$l=hg(0),Td=hg(1),dg=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},fg=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},pg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},mg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function gg(n){return(e,t,i,s,r)=>Rr(e,t,(o,a,l,c,u,d,h,f,p,v,g)=>{let{pxRound:m,points:S}=o,A,b;c.ori==0?(A=Xl,b=dg):(A=ql,b=fg);let C=Xt(S.width*Ct,3),T=(S.size-S.width)/2*Ct,N=Xt(T*2,3),y=new Path2D,E=new Path2D,{left:F,top:I,width:U,height:k}=e.bbox;$l(E,F-N,I-N,U+N*2,k+N*2);let X=O=>{if(l[O]!=null){let $=m(d(a[O],c,v,f)),H=m(h(l[O],u,g,p));A(y,$+T,H),b(y,$,H,T,0,Ul*2)}};if(r)r.forEach(X);else for(let O=i;O<=s;O++)X(O);return{stroke:C>0?y:null,fill:y,clip:E,flags:go|cd}})}function _g(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var yb=_g(xo),vb=_g(yo);function xg(n){let e=St(n?.alignGaps,0);return(t,i,s,r)=>Rr(t,i,(o,a,l,c,u,d,h,f,p,v,g)=>{[s,r]=Vl(l,s,r);let m=o.pxRound,S=k=>m(d(k,c,v,f)),A=k=>m(h(k,u,g,p)),b,C;c.ori==0?(b=xo,C=yb):(b=yo,C=vb);let T=c.dir*(c.ori==0?1:-1),N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:go},y=N.stroke,E=!1;if(r-s>=v*4){let k=_e=>t.posToVal(_e,c.key,!0),X=null,O=null,$,H,ie,oe=S(a[T==1?s:r]),le=S(a[s]),de=S(a[r]),ue=k(T==1?le+1:de-1);for(let _e=T==1?s:r;_e>=s&&_e<=r;_e+=T){let st=a[_e],Q=(T==1?st<ue:st>ue)?oe:S(st),ae=l[_e];Q==oe?ae!=null?(H=ae,X==null?(b(y,Q,A(H)),$=X=O=H):H<X?X=H:H>O&&(O=H)):ae===null&&(E=!0):(X!=null&&C(y,oe,A(X),A(O),A($),A(H)),ae!=null?(H=ae,b(y,Q,A(H)),X=O=$=H):(X=O=null,ae===null&&(E=!0)),oe=Q,ue=k(oe+T))}X!=null&&X!=O&&ie!=oe&&C(y,oe,A(X),A(O),A($),A(H))}else for(let k=T==1?s:r;k>=s&&k<=r;k+=T){let X=l[k];X===null?E=!0:X!=null&&b(y,S(a[k]),A(X))}let[I,U]=Sd(t,i);if(o.fill!=null||I!=0){let k=N.fill=new Path2D(y),X=o.fillTo(t,i,o.min,o.max,I),O=A(X),$=S(a[s]),H=S(a[r]);T==-1&&([H,$]=[$,H]),b(k,H,O),b(k,$,O)}if(!o.spanGaps){let k=[];E&&k.push(...wd(a,l,s,r,T,S,e)),N.gaps=k=o.gaps(t,i,s,r,k),N.clip=Wl(k,c.ori,f,p,v,g)}return U!=0&&(N.band=U==2?[bs(t,i,s,r,y,-1),bs(t,i,s,r,y,1)]:bs(t,i,s,r,y,U)),N})}function bb(n){let e=St(n.align,1),t=St(n.ascDesc,!1),i=St(n.alignGaps,0),s=St(n.extend,!1);return(r,o,a,l)=>Rr(r,o,(c,u,d,h,f,p,v,g,m,S,A)=>{[a,l]=Vl(d,a,l);let b=c.pxRound,{left:C,width:T}=r.bbox,N=le=>b(p(le,h,S,g)),y=le=>b(v(le,f,A,m)),E=h.ori==0?xo:yo,F={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:go},I=F.stroke,U=h.dir*(h.ori==0?1:-1),k=y(d[U==1?a:l]),X=N(u[U==1?a:l]),O=X,$=X;s&&e==-1&&($=C,E(I,$,k)),E(I,X,k);for(let le=U==1?a:l;le>=a&&le<=l;le+=U){let de=d[le];if(de==null)continue;let ue=N(u[le]),_e=y(de);e==1?E(I,ue,k):E(I,O,_e),E(I,ue,_e),k=_e,O=ue}let H=O;s&&e==1&&(H=C+T,E(I,H,k));let[ie,oe]=Sd(r,o);if(c.fill!=null||ie!=0){let le=F.fill=new Path2D(I),de=c.fillTo(r,o,c.min,c.max,ie),ue=y(de);E(le,H,ue),E(le,$,ue)}if(!c.spanGaps){let le=[];le.push(...wd(u,d,a,l,U,N,i));let de=c.width*Ct/2,ue=t||e==1?de:-de,_e=t||e==-1?-de:de;le.forEach(st=>{st[0]+=ue,st[1]+=_e}),F.gaps=le=c.gaps(r,o,a,l,le),F.clip=Wl(le,h.ori,g,m,S,A)}return oe!=0&&(F.band=oe==2?[bs(r,o,a,l,I,-1),bs(r,o,a,l,I,1)]:bs(r,o,a,l,I,oe)),F})}function Lm(n,e,t,i,s,r,o=Wt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Sn(n[l]-n[a]);u<c&&(c=u,o=Sn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function Mb(n){n=n||va;let e=St(n.size,[.6,Wt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=gt(s),o=1-e[0],a=St(e[1],Wt),l=St(e[2],1),c=St(n.disp,va),u=St(n.each,f=>{}),{fill:d,stroke:h}=c;return(f,p,v,g)=>Rr(f,p,(m,S,A,b,C,T,N,y,E,F,I)=>{let U=m.pxRound,k=t,X=i*Ct,O=a*Ct,$=l*Ct,H,ie;b.ori==0?[H,ie]=r(f,p):[ie,H]=r(f,p);let oe=b.dir*(b.ori==0?1:-1),le=b.ori==0?$l:Td,de=b.ori==0?u:(fe,R,x,q,K,ee,me)=>{u(fe,R,x,K,q,me,ee)},ue=St(f.bands,xd).find(fe=>fe.series[0]==p),_e=ue!=null?ue.dir:0,st=m.fillTo(f,p,m.min,m.max,_e),et=U(N(st,C,I,E)),Q,ae,he,Ve=F,De=U(m.width*Ct),ke=!1,wt=null,Ye=null,pt=null,ct=null;d!=null&&(De==0||h!=null)&&(ke=!0,wt=d.values(f,p,v,g),Ye=new Map,new Set(wt).forEach(fe=>{fe!=null&&Ye.set(fe,new Path2D)}),De>0&&(pt=h.values(f,p,v,g),ct=new Map,new Set(pt).forEach(fe=>{fe!=null&&ct.set(fe,new Path2D)})));let{x0:ot,size:qt}=c;if(ot!=null&&qt!=null){k=1,S=ot.values(f,p,v,g),ot.unit==2&&(S=S.map(x=>f.posToVal(y+x*F,b.key,!0)));let fe=qt.values(f,p,v,g);qt.unit==2?ae=fe[0]*F:ae=T(fe[0],b,F,y)-T(0,b,F,y),Ve=Lm(S,A,T,b,F,y,Ve),he=Ve-ae+X}else Ve=Lm(S,A,T,b,F,y,Ve),he=Ve*o+X,ae=Ve-he;he<1&&(he=0),De>=ae/2&&(De=0),he<5&&(U=zm);let en=he>0,$t=Ve-he-(en?De:0);ae=U(od($t,$,O)),Q=(k==0?ae/2:k==oe?0:ae)-k*oe*((k==0?X/2:0)+(en?De/2:0));let bt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Ut=ke?null:new Path2D,Pt=null;if(ue!=null)Pt=f.data[ue.series[1]];else{let{y0:fe,y1:R}=c;fe!=null&&R!=null&&(A=R.values(f,p,v,g),Pt=fe.values(f,p,v,g))}let G=H*ae,We=ie*ae;for(let fe=oe==1?v:g;fe>=v&&fe<=g;fe+=oe){let R=A[fe];if(R==null)continue;if(Pt!=null){let ne=Pt[fe]??0;if(R-ne==0)continue;et=N(ne,C,I,E)}let x=b.distr!=2||c!=null?S[fe]:fe,q=T(x,b,F,y),K=N(St(R,st),C,I,E),ee=U(q-Q),me=U(ti(K,et)),ge=U(Wi(K,et)),te=me-ge;if(R!=null){let ne=R<0?We:G,xe=R<0?G:We;ke?(De>0&&pt[fe]!=null&&le(ct.get(pt[fe]),ee,ge+yi(De/2),ae,ti(0,te-De),ne,xe),wt[fe]!=null&&le(Ye.get(wt[fe]),ee,ge+yi(De/2),ae,ti(0,te-De),ne,xe)):le(Ut,ee,ge+yi(De/2),ae,ti(0,te-De),ne,xe),de(f,p,fe,ee-De/2,ge,ae+De,te)}}return De>0?bt.stroke=ke?ct:Ut:ke||(bt._fill=m.width==0?m._fill:m._stroke??m._fill,bt.width=0),bt.fill=ke?Ye:Ut,bt})}function Sb(n,e){let t=St(e?.alignGaps,0);return(i,s,r,o)=>Rr(i,s,(a,l,c,u,d,h,f,p,v,g,m)=>{[r,o]=Vl(c,r,o);let S=a.pxRound,A=H=>S(h(H,u,g,p)),b=H=>S(f(H,d,m,v)),C,T,N;u.ori==0?(C=Xl,N=xo,T=pg):(C=ql,N=yo,T=mg);let y=u.dir*(u.ori==0?1:-1),E=A(l[y==1?r:o]),F=E,I=[],U=[];for(let H=y==1?r:o;H>=r&&H<=o;H+=y)if(c[H]!=null){let oe=l[H],le=A(oe);I.push(F=le),U.push(b(c[H]))}let k={stroke:n(I,U,C,N,T,S),fill:null,clip:null,band:null,gaps:null,flags:go},X=k.stroke,[O,$]=Sd(i,s);if(a.fill!=null||O!=0){let H=k.fill=new Path2D(X),ie=a.fillTo(i,s,a.min,a.max,O),oe=b(ie);N(H,F,oe),N(H,E,oe)}if(!a.spanGaps){let H=[];H.push(...wd(l,c,r,o,y,A,t)),k.gaps=H=a.gaps(i,s,r,o,H),k.clip=Wl(H,u.ori,p,v,g,m)}return $!=0&&(k.band=$==2?[bs(i,s,r,o,X,-1),bs(i,s,r,o,X,1)]:bs(i,s,r,o,X,$)),k})}function wb(n){return Sb(Tb,n)}function Tb(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),d=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],d[h]=n[h+1]-n[h],c[h]=u[h]/d[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(d[h-1]+d[h])/((2*d[h]+d[h-1])/c[h-1]+(d[h]+2*d[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+d[h]/3,e[h]+l[h]*d[h]/3,n[h+1]-d[h]/3,e[h+1]-l[h+1]*d[h]/3,n[h+1],e[h+1])}return a}var ud=new Set;function Nm(){for(let n of ud)n.syncRect(!0)}_o&&(Ar(rv,ho,Nm),Ar(ov,ho,Nm,!0),Ar(Ol,ho,()=>{wn.pxRatio=Ct}));var Eb=xg(),Ab=gg();function Dm(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>hd(r,o,e,t))}function Cb(n,e){return n.map((t,i)=>i==0?{}:_n({},e,t))}function hd(n,e,t,i){return _n({},e==0?t:i,n)}function yg(n,e,t){return e==null?po:[e,t]}var Rb=yg;function Pb(n,e,t){return e==null?po:kl(e,t,gd,!0)}function vg(n,e,t,i){return e==null?po:zl(e,t,n.scales[i].log,!1)}var Ib=vg;function bg(n,e,t,i){return e==null?po:md(e,t,n.scales[i].log,!1)}var Lb=bg;function Nb(n,e,t,i,s){let r=ti(dm(n),dm(e)),o=e-n,a=Hi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Hs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Fm(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Mn((t=+s)*Ct))+"px"),[n,e,t]}function Db(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Xt(e[2]*Ct,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function wn(n,e,t){let i={mode:St(n.mode,1)},s=i.mode;function r(_,M,L,D){let B=M.valToPct(_);return D+L*(M.dir==-1?1-B:B)}function o(_,M,L,D){let B=M.valToPct(_);return D+L*(M.dir==-1?B:1-B)}function a(_,M,L,D){return M.ori==0?r(_,M,L,D):o(_,M,L,D)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Li(zy);if(n.id!=null&&(c.id=n.id),xi(c,n.class),n.title){let _=Li(Wy,c);_.textContent=n.title}let u=Gi("canvas"),d=i.ctx=u.getContext("2d"),h=Li(Xy,c);Ar("click",h,_=>{_.target===p&&(Yt!=to||nn!=no)&&On.click(i,_)},!0);let f=i.under=Li(qy,h);h.appendChild(u);let p=i.over=Li($y,h);n=mo(n);let v=+St(n.pxAlign,1),g=Im(v);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});let m=n.ms||.001,S=i.series=s==1?Dm(n.series||[],wm,Rm,!1):Cb(n.series||[null],Cm),A=i.axes=Dm(n.axes||[],Sm,Em,!0),b=i.scales={},C=i.bands=n.bands||[];C.forEach(_=>{_.fill=gt(_.fill||null),_.dir=St(_.dir,-1)});let T=s==2?S[1].facets[0].scale:S[0].scale,N={axes:Vt,series:Ot},y=(n.drawOrder||["axes","series"]).map(_=>N[_]);function E(_){let M=_.distr==3?L=>vs(L>0?L:_.clamp(i,L,_.min,_.max,_.key)):_.distr==4?L=>jh(L,_.asinh):_.distr==100?L=>_.fwd(L):L=>L;return L=>{let D=M(L),{_min:B,_max:Z}=_,re=Z-B;return(D-B)/re}}function F(_){let M=b[_];if(M==null){let L=(n.scales||va)[_]||va;if(L.from!=null){F(L.from);let D=_n({},b[L.from],L,{key:_});D.valToPct=E(D),b[_]=D}else{M=b[_]=_n({},_==T?cg:gb,L),M.key=_;let D=M.time,B=M.range,Z=Gs(B);if((_!=T||s==2&&!D)&&(Z&&(B[0]==null||B[1]==null)&&(B={min:B[0]==null?cm:{mode:1,hard:B[0],soft:B[0]},max:B[1]==null?cm:{mode:1,hard:B[1],soft:B[1]}},Z=!1),!Z&&Hl(B))){let re=B;B=(pe,ye,Re)=>ye==null?po:kl(ye,Re,re)}M.range=gt(B||(D?Rb:_==T?M.distr==3?Ib:M.distr==4?Lb:yg:M.distr==3?vg:M.distr==4?bg:Pb)),M.auto=gt(Z?!1:M.auto),M.clamp=gt(M.clamp||mb),M._min=M._max=null,M.valToPct=E(M)}}}F("x"),F("y"),s==1&&S.forEach(_=>{F(_.scale)}),A.forEach(_=>{F(_.scale)});for(let _ in n.scales)F(_);let I=b[T],U=I.distr,k,X;I.ori==0?(xi(c,Gy),k=r,X=o):(xi(c,Hy),k=o,X=r);let O={};for(let _ in b){let M=b[_];(M.min!=null||M.max!=null)&&(O[_]={min:M.min,max:M.max},M.min=M.max=null)}let $=n.tzDate||(_=>new Date(Mn(_/m))),H=n.fmtDate||yd,ie=m==1?Gv($):Xv($),oe=vm($,ym(m==1?zv:Wv,H)),le=Mm($,bm($v,H)),de=[],ue=i.legend=_n({},Kv,n.legend),_e=i.cursor=_n({},nb,{drag:{y:s==2}},n.cursor),st=ue.show,et=_e.show,Q=ue.markers;ue.idxs=de,Q.width=gt(Q.width),Q.dash=gt(Q.dash),Q.stroke=gt(Q.stroke),Q.fill=gt(Q.fill);let ae,he,Ve,De=[],ke=[],wt,Ye=!1,pt={};if(ue.live){let _=S[1]?S[1].values:null;Ye=_!=null,wt=Ye?_(i,1,0):{_:0};for(let M in wt)pt[M]=fd}if(st)if(ae=Gi("table",Qy,c),Ve=Gi("tbody",null,ae),ue.mount(i,ae),Ye){he=Gi("thead",null,ae,Ve);let _=Gi("tr",null,he);Gi("th",null,_);for(var ct in wt)Gi("th",Kp,_).textContent=ct}else xi(ae,tv),ue.live&&xi(ae,ev);let ot={show:!0},qt={show:!1};function en(_,M){if(M==0&&(Ye||!ue.live||s==2))return po;let L=[],D=Gi("tr",nv,Ve,Ve.childNodes[M]);xi(D,_.class),_.show||xi(D,Er);let B=Gi("th",null,D);if(Q.show){let pe=Li(iv,B);if(M>0){let ye=Q.width(i,M);ye&&(pe.style.border=ye+"px "+Q.dash(i,M)+" "+Q.stroke(i,M)),pe.style.background=Q.fill(i,M)}}let Z=Li(Kp,B);_.label instanceof HTMLElement?Z.appendChild(_.label):Z.textContent=_.label,M>0&&(Q.show||(Z.style.color=_.width>0?Q.stroke(i,M):Q.fill(i,M)),bt("click",B,pe=>{if(_e._lock)return;Ne(pe);let ye=S.indexOf(_);if((pe.ctrlKey||pe.metaKey)!=ue.isolate){let Re=S.some((Le,Fe)=>Fe>0&&Fe!=ye&&Le.show);S.forEach((Le,Fe)=>{Fe>0&&ns(Fe,Re?Fe==ye?ot:qt:ot,!0,gn.setSeries)})}else ns(ye,{show:!_.show},!0,gn.setSeries)},!1),Fn&&bt(em,B,pe=>{_e._lock||(Ne(pe),ns(S.indexOf(_),so,!0,gn.setSeries))},!1));for(var re in wt){let pe=Gi("td",sv,D);pe.textContent="--",L.push(pe)}return[D,L]}let $t=new Map;function bt(_,M,L,D=!0){let B=$t.get(M)||{},Z=_e.bind[_](i,M,L,D);Z&&(Ar(_,M,B[_]=Z),$t.set(M,B))}function Ut(_,M,L){let D=$t.get(M)||{};for(let B in D)(_==null||B==_)&&(rd(B,M,D[B]),delete D[B]);_==null&&$t.delete(M)}let Pt=0,G=0,We=0,fe=0,R=0,x=0,q=R,K=x,ee=We,me=fe,ge=0,te=0,ne=0,xe=0;i.bbox={};let Be=!1,Me=!1,ve=!1,Oe=!1,Xe=!1,qe=!1;function V(_,M,L){(L||_!=i.width||M!=i.height)&&be(_,M),Kn(!1),ve=!0,Me=!0,jr()}function be(_,M){i.width=Pt=We=_,i.height=G=fe=M,R=x=0,ce(),ze();let L=i.bbox;ge=L.left=wr(R*Ct,.5),te=L.top=wr(x*Ct,.5),ne=L.width=wr(We*Ct,.5),xe=L.height=wr(fe*Ct,.5)}let se=3;function Se(){let _=!1,M=0;for(;!_;){M++;let L=an(M),D=ts(M);_=M==se||L&&D,_||(be(i.width,i.height),Me=!0)}}function Ae({width:_,height:M}){V(_,M)}i.setSize=Ae;function ce(){let _=!1,M=!1,L=!1,D=!1;A.forEach((B,Z)=>{if(B.show&&B._show){let{side:re,_size:pe}=B,ye=re%2,Re=B.label!=null?B.labelSize:0,Le=pe+Re;Le>0&&(ye?(We-=Le,re==3?(R+=Le,D=!0):L=!0):(fe-=Le,re==0?(x+=Le,_=!0):M=!0))}}),$n[0]=_,$n[1]=L,$n[2]=M,$n[3]=D,We-=di[1]+di[3],R+=di[3],fe-=di[2]+di[0],x+=di[0]}function ze(){let _=R+We,M=x+fe,L=R,D=x;function B(Z,re){switch(Z){case 1:return _+=re,_-re;case 2:return M+=re,M-re;case 3:return L-=re,L+re;case 0:return D-=re,D+re}}A.forEach((Z,re)=>{if(Z.show&&Z._show){let pe=Z.side;Z._pos=B(pe,Z._size),Z.label!=null&&(Z._lpos=B(pe,Z.labelSize))}})}if(_e.dataIdx==null){let _=_e.hover,M=_.skip=new Set(_.skip??[]);M.add(void 0);let L=_.prox=gt(_.prox),D=_.bias??=0;_e.dataIdx=(B,Z,re,pe)=>{if(Z==0)return re;let ye=re,Re=L(B,Z,re,pe)??Wt,Le=Re>=0&&Re<Wt,Fe=I.ori==0?We:fe,nt=_e.left,At=e[0],Mt=e[Z];if(M.has(Mt[re])){ye=null;let dt=null,Ze=null,He;if(D==0||D==-1)for(He=re;dt==null&&He-- >0;)M.has(Mt[He])||(dt=He);if(D==0||D==1)for(He=re;Ze==null&&He++<Mt.length;)M.has(Mt[He])||(Ze=He);if(dt!=null||Ze!=null)if(Le){let Kt=dt==null?-1/0:k(At[dt],I,Fe,0),cn=Ze==null?1/0:k(At[Ze],I,Fe,0),Ln=nt-Kt,zt=cn-nt;Ln<=zt?Ln<=Re&&(ye=dt):zt<=Re&&(ye=Ze)}else ye=Ze==null?dt:dt==null?Ze:re-dt<=Ze-re?dt:Ze}else Le&&Sn(nt-k(At[re],I,Fe,0))>Re&&(ye=null);return ye}}let Ne=_=>{_e.event=_};_e.idxs=de,_e._lock=!1;let lt=_e.points;lt.show=gt(lt.show),lt.size=gt(lt.size),lt.stroke=gt(lt.stroke),lt.width=gt(lt.width),lt.fill=gt(lt.fill);let ht=i.focus=_n({},n.focus||{alpha:.3},_e.focus),Fn=ht.prox>=0,Un=Fn&&lt.one,oi=[],Ns=[],_s=[];function Kr(_,M){let L=lt.show(i,M);if(L instanceof HTMLElement)return xi(L,jy),xi(L,_.class),os(L,-10,-10,We,fe),p.insertBefore(L,oi[M]),L}function bl(_,M){if(s==1||M>0){let L=s==1&&b[_.scale].time,D=_.value;_.value=L?mm(D)?Mm($,bm(D,H)):D||le:D||db,_.label=_.label||(L?sb:ib)}if(Un||M>0){_.width=_.width==null?1:_.width,_.paths=_.paths||Eb||gv,_.fillTo=gt(_.fillTo||_b),_.pxAlign=+St(_.pxAlign,v),_.pxRound=Im(_.pxAlign),_.stroke=gt(_.stroke||null),_.fill=gt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let L=fb(ti(1,_.width),1),D=_.points=_n({},{size:L,width:ti(1,L*.2),stroke:_.stroke,space:L*2,paths:Ab,_stroke:null,_fill:null},_.points);D.show=gt(D.show),D.filter=gt(D.filter),D.fill=gt(D.fill),D.stroke=gt(D.stroke),D.paths=gt(D.paths),D.pxAlign=_.pxAlign}if(st){let L=en(_,M);De.splice(M,0,L[0]),ke.splice(M,0,L[1]),ue.values.push(null)}if(et){de.splice(M,0,null);let L=null;Un?M==0&&(L=Kr(_,M)):M>0&&(L=Kr(_,M)),oi.splice(M,0,L),Ns.splice(M,0,0),_s.splice(M,0,0)}In("addSeries",M)}function Ml(_,M){M=M??S.length,_=s==1?hd(_,M,wm,Rm):hd(_,M,{},Cm),S.splice(M,0,_),bl(S[M],M)}i.addSeries=Ml;function Sl(_){if(S.splice(_,1),st){ue.values.splice(_,1),ke.splice(_,1);let M=De.splice(_,1)[0];Ut(null,M.firstChild),M.remove()}et&&(de.splice(_,1),oi.splice(_,1)[0].remove(),Ns.splice(_,1),_s.splice(_,1)),In("delSeries",_)}i.delSeries=Sl;let $n=[!1,!1,!1,!1];function ra(_,M){if(_._show=_.show,_.show){let L=_.side%2,D=b[_.scale];D==null&&(_.scale=L?S[1].scale:T,D=b[_.scale]);let B=D.time;_.size=gt(_.size),_.space=gt(_.space),_.rotate=gt(_.rotate),Gs(_.incrs)&&_.incrs.forEach(re=>{!Hs.has(re)&&Hs.set(re,Wm(re))}),_.incrs=gt(_.incrs||(D.distr==2?kv:B?m==1?Vv:Hv:Tr)),_.splits=gt(_.splits||(B&&D.distr==1?ie:D.distr==3?ad:D.distr==4?ab:ob)),_.stroke=gt(_.stroke),_.grid.stroke=gt(_.grid.stroke),_.ticks.stroke=gt(_.ticks.stroke),_.border.stroke=gt(_.border.stroke);let Z=_.values;_.values=Gs(Z)&&!Gs(Z[0])?gt(Z):B?Gs(Z)?vm($,ym(Z,H)):mm(Z)?qv($,Z):Z||oe:Z||rb,_.filter=gt(_.filter||(D.distr>=3&&D.log==10?ub:D.distr==3&&D.log==2?hb:Gm)),_.font=Fm(_.font),_.labelFont=Fm(_.labelFont),_._size=_.size(i,null,M,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&($n[M]=!0,_._el=Li(Yy,h))}}function Ds(_,M,L,D){let[B,Z,re,pe]=L,ye=M%2,Re=0;return ye==0&&(pe||Z)&&(Re=M==0&&!B||M==2&&!re?Mn(Sm.size/3):0),ye==1&&(B||re)&&(Re=M==1&&!Z||M==3&&!pe?Mn(Em.size/2):0),Re}let oa=i.padding=(n.padding||[Ds,Ds,Ds,Ds]).map(_=>gt(St(_,Ds))),di=i._padding=oa.map((_,M)=>_(i,M,$n,0)),mn,rn=null,fn=null,xr=s==1?S[0].idxs:null,fi=null,yr=!1;function wl(_,M){if(e=_??[],i.data=i._data=e,s==2){mn=0;for(let L=1;L<S.length;L++)mn+=e[L][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),fi=e[0],mn=fi.length;let L=e;if(U==2){L=e.slice();let D=L[0]=Array(mn);for(let B=0;B<mn;B++)D[B]=B}i._data=e=L}if(Kn(!0),In("setData"),U==2&&(ve=!0),M!==!1){let L=I;L.auto(i,yr)?aa():Os(T,L.min,L.max),Oe=Oe||_e.left>=0,qe=!0,jr()}}i.setData=wl;function aa(){yr=!0;let _,M;s==1&&(mn>0?(rn=xr[0]=0,fn=xr[1]=mn-1,_=e[0][rn],M=e[0][fn],U==2?(_=rn,M=fn):_==M&&(U==3?[_,M]=zl(_,_,I.log,!1):U==4?[_,M]=md(_,_,I.log,!1):I.time?M=_+Mn(86400/m):[_,M]=kl(_,M,gd,!0))):(rn=xr[0]=_=null,fn=xr[1]=M=null)),Os(T,_,M)}let w,W,j,Y,J,Te,Pe,we,Ue,Ce;function tt(_,M,L,D,B,Z){_??=jp,L??=xd,D??="butt",B??=jp,Z??="round",_!=w&&(d.strokeStyle=w=_),B!=W&&(d.fillStyle=W=B),M!=j&&(d.lineWidth=j=M),Z!=J&&(d.lineJoin=J=Z),D!=Te&&(d.lineCap=Te=D),L!=Y&&d.setLineDash(Y=L)}function rt(_,M,L,D){M!=W&&(d.fillStyle=W=M),_!=Pe&&(d.font=Pe=_),L!=we&&(d.textAlign=we=L),D!=Ue&&(d.textBaseline=Ue=D)}function Ge(_,M,L,D,B=0){if(D.length>0&&_.auto(i,yr)&&(M==null||M.min==null)){let Z=St(rn,0),re=St(fn,D.length-1),pe=L.min==null?uv(D,Z,re,B,_.distr==3):[L.min,L.max];_.min=Wi(_.min,L.min=pe[0]),_.max=ti(_.max,L.max=pe[1])}}let Tt={min:null,max:null};function on(){for(let D in b){let B=b[D];O[D]==null&&(B.min==null||O[T]!=null&&B.auto(i,yr))&&(O[D]=Tt)}for(let D in b){let B=b[D];O[D]==null&&B.from!=null&&O[B.from]!=null&&(O[D]=Tt)}O[T]!=null&&Kn(!0);let _={};for(let D in O){let B=O[D];if(B!=null){let Z=_[D]=mo(b[D],yv);if(B.min!=null)_n(Z,B);else if(D!=T||s==2)if(mn==0&&Z.from==null){let re=Z.range(i,null,null,D);Z.min=re[0],Z.max=re[1]}else Z.min=Wt,Z.max=-Wt}}if(mn>0){S.forEach((D,B)=>{if(s==1){let Z=D.scale,re=O[Z];if(re==null)return;let pe=_[Z];if(B==0){let ye=pe.range(i,pe.min,pe.max,Z);pe.min=ye[0],pe.max=ye[1],rn=Hi(pe.min,e[0]),fn=Hi(pe.max,e[0]),fn-rn>1&&(e[0][rn]<pe.min&&rn++,e[0][fn]>pe.max&&fn--),D.min=fi[rn],D.max=fi[fn]}else D.show&&D.auto&&Ge(pe,re,D,e[B],D.sorted);D.idxs[0]=rn,D.idxs[1]=fn}else if(B>0&&D.show&&D.auto){let[Z,re]=D.facets,pe=Z.scale,ye=re.scale,[Re,Le]=e[B],Fe=_[pe],nt=_[ye];Fe!=null&&Ge(Fe,O[pe],Z,Re,Z.sorted),nt!=null&&Ge(nt,O[ye],re,Le,re.sorted),D.min=re.min,D.max=re.max}});for(let D in _){let B=_[D],Z=O[D];if(B.from==null&&(Z==null||Z.min==null)){let re=B.range(i,B.min==Wt?null:B.min,B.max==-Wt?null:B.max,D);B.min=re[0],B.max=re[1]}}}for(let D in _){let B=_[D];if(B.from!=null){let Z=_[B.from];if(Z.min==null)B.min=B.max=null;else{let re=B.range(i,Z.min,Z.max,D);B.min=re[0],B.max=re[1]}}}let M={},L=!1;for(let D in _){let B=_[D],Z=b[D];if(Z.min!=B.min||Z.max!=B.max){Z.min=B.min,Z.max=B.max;let re=Z.distr;Z._min=re==3?vs(Z.min):re==4?jh(Z.min,Z.asinh):re==100?Z.fwd(Z.min):Z.min,Z._max=re==3?vs(Z.max):re==4?jh(Z.max,Z.asinh):re==100?Z.fwd(Z.max):Z.max,M[D]=L=!0}}if(L){S.forEach((D,B)=>{s==2?B>0&&M.y&&(D._paths=null):M[D.scale]&&(D._paths=null)});for(let D in M)ve=!0,In("setScale",D);et&&_e.left>=0&&(Oe=qe=!0)}for(let D in O)O[D]=null}function tn(_){let M=od(rn-1,0,mn-1),L=od(fn+1,0,mn-1);for(;_[M]==null&&M>0;)M--;for(;_[L]==null&&L<mn-1;)L++;return[M,L]}function Ot(){if(mn>0){let _=S.some(M=>M._focus)&&Ce!=ht.alpha;_&&(d.globalAlpha=Ce=ht.alpha),S.forEach((M,L)=>{if(L>0&&M.show&&(bn(L,!1),bn(L,!0),M._paths==null)){let D=Ce;Ce!=M.alpha&&(d.globalAlpha=Ce=M.alpha);let B=s==2?[0,e[L][0].length-1]:tn(e[L]);M._paths=M.paths(i,L,B[0],B[1]),Ce!=D&&(d.globalAlpha=Ce=D)}}),S.forEach((M,L)=>{if(L>0&&M.show){let D=Ce;Ce!=M.alpha&&(d.globalAlpha=Ce=M.alpha),M._paths!=null&&Ie(L,!1);{let B=M._paths!=null?M._paths.gaps:null,Z=M.points.show(i,L,rn,fn,B),re=M.points.filter(i,L,Z,B);(Z||re)&&(M.points._paths=M.points.paths(i,L,rn,fn,re),Ie(L,!0))}Ce!=D&&(d.globalAlpha=Ce=D),In("drawSeries",L)}}),_&&(d.globalAlpha=Ce=1)}}function bn(_,M){let L=M?S[_].points:S[_];L._stroke=L.stroke(i,_),L._fill=L.fill(i,_)}function Ie(_,M){let L=M?S[_].points:S[_],{stroke:D,fill:B,clip:Z,flags:re,_stroke:pe=L._stroke,_fill:ye=L._fill,_width:Re=L.width}=L._paths;Re=Xt(Re*Ct,3);let Le=null,Fe=Re%2/2;M&&ye==null&&(ye=Re>0?"#fff":pe);let nt=L.pxAlign==1&&Fe>0;if(nt&&d.translate(Fe,Fe),!M){let At=ge-Re/2,Mt=te-Re/2,dt=ne+Re,Ze=xe+Re;Le=new Path2D,Le.rect(At,Mt,dt,Ze)}M?Vn(pe,Re,L.dash,L.cap,ye,D,B,re,Z):Yn(_,pe,Re,L.dash,L.cap,ye,D,B,re,Le,Z),nt&&d.translate(-Fe,-Fe)}function Yn(_,M,L,D,B,Z,re,pe,ye,Re,Le){let Fe=!1;ye!=0&&C.forEach((nt,At)=>{if(nt.series[0]==_){let Mt=S[nt.series[1]],dt=e[nt.series[1]],Ze=(Mt._paths||va).band;Gs(Ze)&&(Ze=nt.dir==1?Ze[0]:Ze[1]);let He,Kt=null;Mt.show&&Ze&&dv(dt,rn,fn)?(Kt=nt.fill(i,At)||Z,He=Mt._paths.clip):Ze=null,Vn(M,L,D,B,Kt,re,pe,ye,Re,Le,He,Ze),Fe=!0}}),Fe||Vn(M,L,D,B,Z,re,pe,ye,Re,Le)}let mt=go|cd;function Vn(_,M,L,D,B,Z,re,pe,ye,Re,Le,Fe){tt(_,M,L,D,B),(ye||Re||Fe)&&(d.save(),ye&&d.clip(ye),Re&&d.clip(Re)),Fe?(pe&mt)==mt?(d.clip(Fe),Le&&d.clip(Le),pi(B,re),Zn(_,Z,M)):pe&cd?(pi(B,re),d.clip(Fe),Zn(_,Z,M)):pe&go&&(d.save(),d.clip(Fe),Le&&d.clip(Le),pi(B,re),d.restore(),Zn(_,Z,M)):(pi(B,re),Zn(_,Z,M)),(ye||Re||Fe)&&d.restore()}function Zn(_,M,L){L>0&&(M instanceof Map?M.forEach((D,B)=>{d.strokeStyle=w=B,d.stroke(D)}):M!=null&&_&&d.stroke(M))}function pi(_,M){M instanceof Map?M.forEach((L,D)=>{d.fillStyle=W=D,d.fill(L)}):M!=null&&_&&d.fill(M)}function Fs(_,M,L,D){let B=A[_],Z;if(D<=0)Z=[0,0];else{let re=B._space=B.space(i,_,M,L,D),pe=B._incrs=B.incrs(i,_,M,L,D,re);Z=Nb(M,L,pe,D,re)}return B._found=Z}function Et(_,M,L,D,B,Z,re,pe,ye,Re){let Le=re%2/2;v==1&&d.translate(Le,Le),tt(pe,re,ye,Re,pe),d.beginPath();let Fe,nt,At,Mt,dt=B+(D==0||D==3?-Z:Z);L==0?(nt=B,Mt=dt):(Fe=B,At=dt);for(let Ze=0;Ze<_.length;Ze++)M[Ze]!=null&&(L==0?Fe=At=_[Ze]:nt=Mt=_[Ze],d.moveTo(Fe,nt),d.lineTo(At,Mt));d.stroke(),v==1&&d.translate(-Le,-Le)}function an(_){let M=!0;return A.forEach((L,D)=>{if(!L.show)return;let B=b[L.scale];if(B.min==null){L._show&&(M=!1,L._show=!1,Kn(!1));return}else L._show||(M=!1,L._show=!0,Kn(!1));let Z=L.side,re=Z%2,{min:pe,max:ye}=B,[Re,Le]=Fs(D,pe,ye,re==0?We:fe);if(Le==0)return;let Fe=B.distr==2,nt=L._splits=L.splits(i,D,pe,ye,Re,Le,Fe),At=B.distr==2?nt.map(He=>fi[He]):nt,Mt=B.distr==2?fi[nt[1]]-fi[nt[0]]:Re,dt=L._values=L.values(i,L.filter(i,At,D,Le,Mt),D,Le,Mt);L._rotate=Z==2?L.rotate(i,dt,D,Le):0;let Ze=L._size;L._size=Ni(L.size(i,dt,D,_)),Ze!=null&&L._size!=Ze&&(M=!1)}),M}function ts(_){let M=!0;return oa.forEach((L,D)=>{let B=L(i,D,$n,_);B!=di[D]&&(M=!1),di[D]=B}),M}function Vt(){for(let _=0;_<A.length;_++){let M=A[_];if(!M.show||!M._show)continue;let L=M.side,D=L%2,B,Z,re=M.stroke(i,_),pe=L==0||L==3?-1:1,[ye,Re]=M._found;if(M.label!=null){let jn=M.labelGap*pe,_i=Mn((M._lpos+jn)*Ct);rt(M.labelFont[0],re,"center",L==2?"top":Jp),d.save(),D==1?(B=Z=0,d.translate(_i,Mn(te+xe/2)),d.rotate((L==3?-Ul:Ul)/2)):(B=Mn(ge+ne/2),Z=_i);let Mr=Vm(M.label)?M.label(i,_,ye,Re):M.label;d.fillText(Mr,B,Z),d.restore()}if(Re==0)continue;let Le=b[M.scale],Fe=D==0?ne:xe,nt=D==0?ge:te,At=M._splits,Mt=Le.distr==2?At.map(jn=>fi[jn]):At,dt=Le.distr==2?fi[At[1]]-fi[At[0]]:ye,Ze=M.ticks,He=M.border,Kt=Ze.show?Ze.size:0,cn=Mn(Kt*Ct),Ln=Mn((M.alignTo==2?M._size-Kt-M.gap:M.gap)*Ct),zt=M._rotate*-Ul/180,un=g(M._pos*Ct),mi=(cn+Ln)*pe,Jn=un+mi;Z=D==0?Jn:0,B=D==1?Jn:0;let Pi=M.font[0],Bi=M.align==1?co:M.align==2?Zh:zt>0?co:zt<0?Zh:D==0?"center":L==3?Zh:co,ss=zt||D==1?"middle":L==2?"top":Jp;rt(Pi,re,Bi,ss);let gi=M.font[1]*M.lineGap,Ii=At.map(jn=>g(a(jn,Le,Fe,nt))),Vi=M._values;for(let jn=0;jn<Vi.length;jn++){let _i=Vi[jn];if(_i!=null){D==0?B=Ii[jn]:Z=Ii[jn],_i=""+_i;let Mr=_i.indexOf(`
`)==-1?[_i]:_i.split(/\n/gm);for(let Qn=0;Qn<Mr.length;Qn++){let Fp=Mr[Qn];zt?(d.save(),d.translate(B,Z+Qn*gi),d.rotate(zt),d.fillText(Fp,0,0),d.restore()):d.fillText(Fp,B,Z+Qn*gi)}}}Ze.show&&Et(Ii,Ze.filter(i,Mt,_,Re,dt),D,L,un,cn,Xt(Ze.width*Ct,3),Ze.stroke(i,_),Ze.dash,Ze.cap);let rs=M.grid;rs.show&&Et(Ii,rs.filter(i,Mt,_,Re,dt),D,D==0?2:1,D==0?te:ge,D==0?xe:ne,Xt(rs.width*Ct,3),rs.stroke(i,_),rs.dash,rs.cap),He.show&&Et([un],[1],D==0?1:0,D==0?1:2,D==1?te:ge,D==1?xe:ne,Xt(He.width*Ct,3),He.stroke(i,_),He.dash,He.cap)}In("drawAxes")}function Kn(_){S.forEach((M,L)=>{L>0&&(M._paths=null,_&&(s==1?(M.min=null,M.max=null):M.facets.forEach(D=>{D.min=null,D.max=null})))})}let ki=!1,Jr=!1,la=[];function py(){Jr=!1;for(let _=0;_<la.length;_++)In(...la[_]);la.length=0}function jr(){ki||(Ev(_p),ki=!0)}function my(_,M=!1){ki=!0,Jr=M,_(i),_p(),M&&la.length>0&&queueMicrotask(py)}i.batch=my;function _p(){if(Be&&(on(),Be=!1),ve&&(Se(),ve=!1),Me){if(Jt(f,co,R),Jt(f,"top",x),Jt(f,ga,We),Jt(f,_a,fe),Jt(p,co,R),Jt(p,"top",x),Jt(p,ga,We),Jt(p,_a,fe),Jt(h,ga,Pt),Jt(h,_a,G),u.width=Mn(Pt*Ct),u.height=Mn(G*Ct),A.forEach(({_el:_,_show:M,_size:L,_pos:D,side:B})=>{if(_!=null)if(M){let Z=B===3||B===0?L:0,re=B%2==1;Jt(_,re?"left":"top",D-Z),Jt(_,re?"width":"height",L),Jt(_,re?"top":"left",re?x:R),Jt(_,re?"height":"width",re?fe:We),sd(_,Er)}else xi(_,Er)}),w=W=j=J=Te=Pe=we=Ue=Y=null,Ce=1,ha(!0),R!=q||x!=K||We!=ee||fe!=me){Kn(!1);let _=We/ee,M=fe/me;if(et&&!Oe&&_e.left>=0){_e.left*=_,_e.top*=M,Qr&&os(Qr,Mn(_e.left),0,We,fe),eo&&os(eo,0,Mn(_e.top),We,fe);for(let L=0;L<oi.length;L++){let D=oi[L];D!=null&&(Ns[L]*=_,_s[L]*=M,os(D,Ni(Ns[L]),Ni(_s[L]),We,fe))}}if(Zt.show&&!Xe&&Zt.left>=0&&Zt.width>0){Zt.left*=_,Zt.width*=_,Zt.top*=M,Zt.height*=M;for(let L in Bh)Jt(io,L,Zt[L])}q=R,K=x,ee=We,me=fe}In("setSize"),Me=!1}Pt>0&&G>0&&(d.clearRect(0,0,u.width,u.height),In("drawClear"),y.forEach(_=>_()),In("draw")),Zt.show&&Xe&&(Tl(Zt),Xe=!1),et&&Oe&&(br(null,!0,!1),Oe=!1),ue.show&&ue.live&&qe&&(Oh(),qe=!1),l||(l=!0,i.status=1,In("ready")),yr=!1,ki=!1}i.redraw=(_,M)=>{ve=M||!1,_!==!1?Os(T,I.min,I.max):jr()};function Dh(_,M){let L=b[_];if(L.from==null){if(mn==0){let D=L.range(i,M.min,M.max,_);M.min=D[0],M.max=D[1]}if(M.min>M.max){let D=M.min;M.min=M.max,M.max=D}if(mn>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;_==T&&L.distr==2&&mn>0&&(M.min=Hi(M.min,e[0]),M.max=Hi(M.max,e[0]),M.min==M.max&&M.max++),O[_]=M,Be=!0,jr()}}i.setScale=Dh;let Fh,Uh,Qr,eo,xp,yp,to,no,vp,bp,Yt,nn,Us=!1,On=_e.drag,Rn=On.x,Pn=On.y;et&&(_e.x&&(Fh=Li(Ky,p)),_e.y&&(Uh=Li(Jy,p)),I.ori==0?(Qr=Fh,eo=Uh):(Qr=Uh,eo=Fh),Yt=_e.left,nn=_e.top);let Zt=i.select=_n({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),io=Zt.show?Li(Zy,Zt.over?p:f):null;function Tl(_,M){if(Zt.show){for(let L in _)Zt[L]=_[L],L in Bh&&Jt(io,L,_[L]);M!==!1&&In("setSelect")}}i.setSelect=Tl;function gy(_){if(S[_].show)st&&sd(De[_],Er);else if(st&&xi(De[_],Er),et){let L=Un?oi[0]:oi[_];L!=null&&os(L,-10,-10,We,fe)}}function Os(_,M,L){Dh(_,{min:M,max:L})}function ns(_,M,L,D){M.focus!=null&&by(_),M.show!=null&&S.forEach((B,Z)=>{Z>0&&(_==Z||_==null)&&(B.show=M.show,gy(Z),s==2?(Os(B.facets[0].scale,null,null),Os(B.facets[1].scale,null,null)):Os(B.scale,null,null),jr())}),L!==!1&&In("setSeries",_,M),D&&da("setSeries",i,_,M)}i.setSeries=ns;function _y(_,M){_n(C[_],M)}function xy(_,M){_.fill=gt(_.fill||null),_.dir=St(_.dir,-1),M=M??C.length,C.splice(M,0,_)}function yy(_){_==null?C.length=0:C.splice(_,1)}i.addBand=xy,i.setBand=_y,i.delBand=yy;function vy(_,M){S[_].alpha=M,et&&oi[_]!=null&&(oi[_].style.opacity=M),st&&De[_]&&(De[_].style.opacity=M)}let xs,ks,vr,so={focus:!0};function by(_){if(_!=vr){let M=_==null,L=ht.alpha!=1;S.forEach((D,B)=>{if(s==1||B>0){let Z=M||B==0||B==_;D._focus=M?null:Z,L&&vy(B,Z?1:ht.alpha)}}),vr=_,L&&jr()}}st&&Fn&&bt(tm,ae,_=>{_e._lock||(Ne(_),vr!=null&&ns(null,so,!0,gn.setSeries))});function is(_,M,L){let D=b[M];L&&(_=_/Ct-(D.ori==1?x:R));let B=We;D.ori==1&&(B=fe,_=B-_),D.dir==-1&&(_=B-_);let Z=D._min,re=D._max,pe=_/B,ye=Z+(re-Z)*pe,Re=D.distr;return Re==3?fo(10,ye):Re==4?pv(ye,D.asinh):Re==100?D.bwd(ye):ye}function My(_,M){let L=is(_,T,M);return Hi(L,e[0],rn,fn)}i.valToIdx=_=>Hi(_,e[0]),i.posToIdx=My,i.posToVal=is,i.valToPos=(_,M,L)=>b[M].ori==0?r(_,b[M],L?ne:We,L?ge:0):o(_,b[M],L?xe:fe,L?te:0),i.setCursor=(_,M,L)=>{Yt=_.left,nn=_.top,br(null,M,L)};function Mp(_,M){Jt(io,co,Zt.left=_),Jt(io,ga,Zt.width=M)}function Sp(_,M){Jt(io,"top",Zt.top=_),Jt(io,_a,Zt.height=M)}let ca=I.ori==0?Mp:Sp,ua=I.ori==1?Mp:Sp;function Sy(){if(st&&ue.live)for(let _=s==2?1:0;_<S.length;_++){if(_==0&&Ye)continue;let M=ue.values[_],L=0;for(let D in M)ke[_][L++].firstChild.nodeValue=M[D]}}function Oh(_,M){if(_!=null&&(_.idxs?_.idxs.forEach((L,D)=>{de[D]=L}):xv(_.idx)||de.fill(_.idx),ue.idx=de[0]),st&&ue.live){for(let L=0;L<S.length;L++)(L>0||s==1&&!Ye)&&wy(L,de[L]);Sy()}qe=!1,M!==!1&&In("setLegend")}i.setLegend=Oh;function wy(_,M){let L=S[_],D=_==0&&U==2?fi:e[_],B;Ye?B=L.values(i,_,M)??pt:(B=L.value(i,M==null?null:D[M],_,M),B=B==null?pt:{_:B}),ue.values[_]=B}function br(_,M,L){vp=Yt,bp=nn,[Yt,nn]=_e.move(i,Yt,nn),_e.left=Yt,_e.top=nn,et&&(Qr&&os(Qr,Mn(Yt),0,We,fe),eo&&os(eo,0,Mn(nn),We,fe));let D,B=rn>fn;xs=Wt,ks=null;let Z=I.ori==0?We:fe,re=I.ori==1?We:fe;if(Yt<0||mn==0||B){D=_e.idx=null;for(let pe=0;pe<S.length;pe++){let ye=oi[pe];ye!=null&&os(ye,-10,-10,We,fe)}Fn&&ns(null,so,!0,_==null&&gn.setSeries),ue.live&&(de.fill(D),qe=!0)}else{let pe,ye,Re;s==1&&(pe=I.ori==0?Yt:nn,ye=is(pe,T),D=_e.idx=Hi(ye,e[0],rn,fn),Re=k(e[0][D],I,Z,0));let Le=-10,Fe=-10,nt=0,At=0,Mt=!0,dt="",Ze="";for(let He=s==2?1:0;He<S.length;He++){let Kt=S[He],cn=de[He],Ln=cn==null?null:s==1?e[He][cn]:e[He][1][cn],zt=_e.dataIdx(i,He,D,ye),un=zt==null?null:s==1?e[He][zt]:e[He][1][zt];if(qe=qe||un!=Ln||zt!=cn,de[He]=zt,He>0&&Kt.show){let mi=zt==null?-10:zt==D?Re:k(s==1?e[0][zt]:e[He][0][zt],I,Z,0),Jn=un==null?-10:X(un,s==1?b[Kt.scale]:b[Kt.facets[1].scale],re,0);if(Fn&&un!=null){let Pi=I.ori==1?Yt:nn,Bi=Sn(ht.dist(i,He,zt,Jn,Pi));if(Bi<xs){let ss=ht.bias;if(ss!=0){let gi=is(Pi,Kt.scale),Ii=un>=0?1:-1,Vi=gi>=0?1:-1;Vi==Ii&&(Vi==1?ss==1?un>=gi:un<=gi:ss==1?un<=gi:un>=gi)&&(xs=Bi,ks=He)}else xs=Bi,ks=He}}if(qe||Un){let Pi,Bi;I.ori==0?(Pi=mi,Bi=Jn):(Pi=Jn,Bi=mi);let ss,gi,Ii,Vi,rs,jn,_i=!0,Mr=lt.bbox;if(Mr!=null){_i=!1;let Qn=Mr(i,He);Ii=Qn.left,Vi=Qn.top,ss=Qn.width,gi=Qn.height}else Ii=Pi,Vi=Bi,ss=gi=lt.size(i,He);if(jn=lt.fill(i,He),rs=lt.stroke(i,He),Un)He==ks&&xs<=ht.prox&&(Le=Ii,Fe=Vi,nt=ss,At=gi,Mt=_i,dt=jn,Ze=rs);else{let Qn=oi[He];Qn!=null&&(Ns[He]=Ii,_s[He]=Vi,lm(Qn,ss,gi,_i),om(Qn,jn,rs),os(Qn,Ni(Ii),Ni(Vi),We,fe))}}}}if(Un){let He=ht.prox,Kt=vr==null?xs<=He:xs>He||ks!=vr;if(qe||Kt){let cn=oi[0];cn!=null&&(Ns[0]=Le,_s[0]=Fe,lm(cn,nt,At,Mt),om(cn,dt,Ze),os(cn,Ni(Le),Ni(Fe),We,fe))}}}if(Zt.show&&Us)if(_!=null){let[pe,ye]=gn.scales,[Re,Le]=gn.match,[Fe,nt]=_.cursor.sync.scales,At=_.cursor.drag;if(Rn=At._x,Pn=At._y,Rn||Pn){let{left:Mt,top:dt,width:Ze,height:He}=_.select,Kt=_.scales[Fe].ori,cn=_.posToVal,Ln,zt,un,mi,Jn,Pi=pe!=null&&Re(pe,Fe),Bi=ye!=null&&Le(ye,nt);Pi&&Rn?(Kt==0?(Ln=Mt,zt=Ze):(Ln=dt,zt=He),un=b[pe],mi=k(cn(Ln,Fe),un,Z,0),Jn=k(cn(Ln+zt,Fe),un,Z,0),ca(Wi(mi,Jn),Sn(Jn-mi))):ca(0,Z),Bi&&Pn?(Kt==1?(Ln=Mt,zt=Ze):(Ln=dt,zt=He),un=b[ye],mi=X(cn(Ln,nt),un,re,0),Jn=X(cn(Ln+zt,nt),un,re,0),ua(Wi(mi,Jn),Sn(Jn-mi))):ua(0,re)}else Vh()}else{let pe=Sn(vp-xp),ye=Sn(bp-yp);if(I.ori==1){let nt=pe;pe=ye,ye=nt}Rn=On.x&&pe>=On.dist,Pn=On.y&&ye>=On.dist;let Re=On.uni;Re!=null?Rn&&Pn&&(Rn=pe>=Re,Pn=ye>=Re,!Rn&&!Pn&&(ye>pe?Pn=!0:Rn=!0)):On.x&&On.y&&(Rn||Pn)&&(Rn=Pn=!0);let Le,Fe;Rn&&(I.ori==0?(Le=to,Fe=Yt):(Le=no,Fe=nn),ca(Wi(Le,Fe),Sn(Fe-Le)),Pn||ua(0,re)),Pn&&(I.ori==1?(Le=to,Fe=Yt):(Le=no,Fe=nn),ua(Wi(Le,Fe),Sn(Fe-Le)),Rn||ca(0,Z)),!Rn&&!Pn&&(ca(0,0),ua(0,0))}if(On._x=Rn,On._y=Pn,_==null){if(L){if(Dp!=null){let[pe,ye]=gn.scales;gn.values[0]=pe!=null?is(I.ori==0?Yt:nn,pe):null,gn.values[1]=ye!=null?is(I.ori==1?Yt:nn,ye):null}da(Kh,i,Yt,nn,We,fe,D)}if(Fn){let pe=L&&gn.setSeries,ye=ht.prox;vr==null?xs<=ye&&ns(ks,so,!0,pe):xs>ye?ns(null,so,!0,pe):ks!=vr&&ns(ks,so,!0,pe)}}qe&&(ue.idx=D,Oh()),M!==!1&&In("setCursor")}let Bs=null;Object.defineProperty(i,"rect",{get(){return Bs==null&&ha(!1),Bs}});function ha(_=!1){_?Bs=null:(Bs=p.getBoundingClientRect(),In("syncRect",Bs))}function wp(_,M,L,D,B,Z,re){_e._lock||Us&&_!=null&&_.movementX==0&&_.movementY==0||(kh(_,M,L,D,B,Z,re,!1,_!=null),_!=null?br(null,!0,!0):br(M,!0,!1))}function kh(_,M,L,D,B,Z,re,pe,ye){if(Bs==null&&ha(!1),Ne(_),_!=null)L=_.clientX-Bs.left,D=_.clientY-Bs.top;else{if(L<0||D<0){Yt=-10,nn=-10;return}let[Re,Le]=gn.scales,Fe=M.cursor.sync,[nt,At]=Fe.values,[Mt,dt]=Fe.scales,[Ze,He]=gn.match,Kt=M.axes[0].side%2==1,cn=I.ori==0?We:fe,Ln=I.ori==1?We:fe,zt=Kt?Z:B,un=Kt?B:Z,mi=Kt?D:L,Jn=Kt?L:D;if(Mt!=null?L=Ze(Re,Mt)?a(nt,b[Re],cn,0):-10:L=cn*(mi/zt),dt!=null?D=He(Le,dt)?a(At,b[Le],Ln,0):-10:D=Ln*(Jn/un),I.ori==1){let Pi=L;L=D,D=Pi}}ye&&(M==null||M.cursor.event.type==Kh)&&((L<=1||L>=We-1)&&(L=wr(L,We)),(D<=1||D>=fe-1)&&(D=wr(D,fe))),pe?(xp=L,yp=D,[to,no]=_e.move(i,L,D)):(Yt=L,nn=D)}let Bh={width:0,height:0,left:0,top:0};function Vh(){Tl(Bh,!1)}let Tp,Ep,Ap,Cp;function Rp(_,M,L,D,B,Z,re){Us=!0,Rn=Pn=On._x=On._y=!1,kh(_,M,L,D,B,Z,re,!0,!1),_!=null&&(bt(Jh,nd,Pp,!1),da(Qp,i,to,no,We,fe,null));let{left:pe,top:ye,width:Re,height:Le}=Zt;Tp=pe,Ep=ye,Ap=Re,Cp=Le}function Pp(_,M,L,D,B,Z,re){Us=On._x=On._y=!1,kh(_,M,L,D,B,Z,re,!1,!0);let{left:pe,top:ye,width:Re,height:Le}=Zt,Fe=Re>0||Le>0,nt=Tp!=pe||Ep!=ye||Ap!=Re||Cp!=Le;if(Fe&&nt&&Tl(Zt),On.setScale&&Fe&&nt){let At=pe,Mt=Re,dt=ye,Ze=Le;if(I.ori==1&&(At=ye,Mt=Le,dt=pe,Ze=Re),Rn&&Os(T,is(At,T),is(At+Mt,T)),Pn)for(let He in b){let Kt=b[He];He!=T&&Kt.from==null&&Kt.min!=Wt&&Os(He,is(dt+Ze,He),is(dt,He))}Vh()}else _e.lock&&(_e._lock=!_e._lock,br(M,!0,_!=null));_!=null&&(Ut(Jh,nd),da(Jh,i,Yt,nn,We,fe,null))}function Ty(_,M,L,D,B,Z,re){if(_e._lock)return;Ne(_);let pe=Us;if(Us){let ye=!0,Re=!0,Le=10,Fe,nt;I.ori==0?(Fe=Rn,nt=Pn):(Fe=Pn,nt=Rn),Fe&&nt&&(ye=Yt<=Le||Yt>=We-Le,Re=nn<=Le||nn>=fe-Le),Fe&&ye&&(Yt=Yt<to?0:We),nt&&Re&&(nn=nn<no?0:fe),br(null,!0,!0),Us=!1}Yt=-10,nn=-10,de.fill(null),br(null,!0,!0),pe&&(Us=pe)}function Ip(_,M,L,D,B,Z,re){_e._lock||(Ne(_),aa(),Vh(),_!=null&&da(nm,i,Yt,nn,We,fe,null))}function Lp(){A.forEach(Db),V(i.width,i.height,!0)}Ar(Ol,ho,Lp);let ro={};ro.mousedown=Rp,ro.mousemove=wp,ro.mouseup=Pp,ro.dblclick=Ip,ro.setSeries=(_,M,L,D)=>{let B=gn.match[2];L=B(i,M,L),L!=-1&&ns(L,D,!0,!1)},et&&(bt(Qp,p,Rp),bt(Kh,p,wp),bt(em,p,_=>{Ne(_),ha(!1)}),bt(tm,p,Ty),bt(nm,p,Ip),ud.add(i),i.syncRect=ha);let El=i.hooks=n.hooks||{};function In(_,M,L){Jr?la.push([_,M,L]):_ in El&&El[_].forEach(D=>{D.call(null,i,M,L)})}(n.plugins||[]).forEach(_=>{for(let M in _.hooks)El[M]=(El[M]||[]).concat(_.hooks[M])});let Np=(_,M,L)=>L,gn=_n({key:null,setSeries:!1,filters:{pub:fm,sub:fm},scales:[T,S[1]?S[1].scale:null],match:[pm,pm,Np],values:[null,null]},_e.sync);gn.match.length==2&&gn.match.push(Np),_e.sync=gn;let Dp=gn.key,zh=ug(Dp);function da(_,M,L,D,B,Z,re){gn.filters.pub(_,M,L,D,B,Z,re)&&zh.pub(_,M,L,D,B,Z,re)}zh.sub(i);function Ey(_,M,L,D,B,Z,re){gn.filters.sub(_,M,L,D,B,Z,re)&&ro[_](null,M,L,D,B,Z,re)}i.pub=Ey;function Ay(){zh.unsub(i),ud.delete(i),$t.clear(),rd(Ol,ho,Lp),c.remove(),ae?.remove(),In("destroy")}i.destroy=Ay;function Gh(){In("init",n,e),wl(e||n.data,!1),O[T]?Dh(T,O[T]):aa(),Xe=Zt.show&&(Zt.width>0||Zt.height>0),Oe=qe=!0,V(n.width,n.height)}return S.forEach(bl),A.forEach(ra),t?t instanceof HTMLElement?(t.appendChild(c),Gh()):t(i,Gh):Gh(),i}wn.assign=_n;wn.fmtNum=_d;wn.rangeNum=kl;wn.rangeLog=zl;wn.rangeAsinh=md;wn.orient=Rr;wn.pxRatio=Ct;wn.join=Tv;wn.fmtDate=yd,wn.tzDate=Uv;wn.sync=ug;{wn.addGap=xb,wn.clipGaps=Wl;let n=wn.paths={points:gg};n.linear=xg,n.stepped=bb,n.bars=Mb,n.spline=wb}function Mg(n,e,t,i,s){return r=>{let{ctx:o,bbox:a}=r,l=devicePixelRatio,c=d=>r.valToPos(d*i,"x",!0),u=d=>d>=a.left-1&&d<=a.left+a.width+1;if(o.save(),n.window){let d=Math.max(a.left,c(n.window.from)),h=Math.min(a.left+a.width,c(n.window.to));o.fillStyle=t.window,h>d&&o.fillRect(d,a.top,h-d,a.height)}o.lineWidth=2*l,o.strokeStyle=t.limit;for(let{value:d}of e){let h=r.valToPos(d*s,"y",!0);h<a.top||h>a.top+a.height||(o.beginPath(),o.moveTo(a.left,h),o.lineTo(a.left+a.width,h),o.stroke())}o.lineWidth=l,o.strokeStyle=t.event,o.fillStyle=t.event,o.setLineDash([2*l,3*l]),o.font=`600 ${11*l}px system-ui, sans-serif`,o.textAlign="center",o.textBaseline="bottom",(n.events??[]).forEach((d,h)=>{let f=c(d.x);u(f)&&(o.beginPath(),o.moveTo(f,a.top),o.lineTo(f,a.top+a.height),o.stroke(),o.fillText(String(h+1),f,a.top-2*l))}),o.restore()}}var Sg="12px system-ui, sans-serif";function Ws(n,e){let t=0;for(let i of n.curves){let s=hn(i.y);s&&(t=Math.max(t,Math.abs(s[0]),Math.abs(s[1])))}return{xScale:kt(Il[n.along],e,1),yScale:kt(n.yUnit,e,t)}}function Ma(n,e){return e.symbol?`${n}, ${e.symbol}`:n}function Fb(n,e,t){let i=zi(t.theme).curve[n.role],s={label:n.label,show:!t.hidden.has(e),stroke:i,width:n.points?0:ao[n.role],dash:oo[n.role],points:n.points?{show:!0,size:6,space:0,fill:zi(t.theme).paper,stroke:i,width:1.5}:{show:!1}};return n.points&&(s.paths=()=>null),s}function Ub(n,e,t,i){let s=zi(e.theme),r={stroke:s.muted,font:Sg,labelFont:Sg,labelSize:20,grid:{stroke:s.grid,width:1},ticks:{stroke:s.grid,width:1,size:4},values:(a,l)=>pa(l)},o=Math.max(3,Math.floor(e.width/110));return[{...r,label:Ma(n.xLabel,t),size:30,splits:(a,l,c,u)=>lo(c,u,o)},{...r,label:Ma(n.yLabel,i),size:(a,l)=>16+7*Math.max(2,...(l??[]).map(c=>String(c).length)),splits:(a,l,c,u)=>lo(c,u,Math.max(3,e.height/55))}]}function wg(n,e,t){let i=Vs(e.curves),{xScale:s,yScale:r}=Ws(e,t.units),o=hn(i.x)??[0,1];o[0]===o[1]&&(o[1]=o[0]+1);let a=s.factor,l=r.factor,c=g=>g.map(m=>m==null?m:m*l),u=[i.x.map(g=>g*a),...i.y.map(c)],d=t.zoom??o,h=zi(t.theme),f=[{},...e.curves.map((g,m)=>Fb(g,m,t))],p=(g,m,S)=>{let[A,b]=Pl(e,(m??0)/l,(S??l)/l);return[A*l,b*l]},v=new wn({width:t.width,height:t.height,padding:[18,14,0,0],pxAlign:0,legend:{show:!1},cursor:{y:!1,drag:{x:!0,y:!1,dist:5},points:{size:7,fill:h.paper,width:2}},scales:{x:{time:!1,range:(g,m,S)=>m===null||S===null?[0,1]:[m,S]},y:{range:p}},axes:Ub(e,t,s,r),series:f,bands:e.band?[{series:[e.band.high+1,e.band.low+1],fill:h.band}]:[],hooks:{setCursor:[g=>{let{left:m,event:S}=g.cursor;S&&t.onCursor(m===void 0||m<0?null:g.posToVal(m,"x")/a)}],setScale:[(g,m)=>{let{min:S,max:A}=g.scales.x;m==="x"&&typeof S=="number"&&typeof A=="number"&&t.onZoom([S/a,A/a])}],drawAxes:[Mg(e,Sr(e),h,a,l)]}},u,n);return v.setScale("x",{min:d[0]*a,max:d[1]*a}),{chart:v,aligned:i,xScale:s,yScale:r,reach:o}}var vo=680,Ms=250,qs=58,wa=12,Xs=16,Pr=40,as=zi("light");function Ob(n,e,t,i,s,r){let o="",a=!1,l=NaN,c=NaN;return n.x.forEach((u,d)=>{let h=n.y[e]?.[d];if(h===void 0||u<t||u>i)return;if(h===null){a=!1;return}let[f,p]=[s(u),r(h)];a&&Math.abs(f-l)<.25&&Math.abs(p-c)<.25||(o+=`${a?"L":"M"}${f.toFixed(1)} ${p.toFixed(1)}`,[a,l,c]=[!0,f,p])}),o}function kb(n,e,t,i,s){let o=n.x.map((c,u)=>({x:c,low:n.y[e]?.[u],high:n.y[t]?.[u]})).filter(c=>typeof c.low=="number"&&typeof c.high=="number");if(o.length<2)return"";let a=o.map(c=>`${i(c.x).toFixed(1)} ${s(c.high).toFixed(1)}`),l=o.reverse().map(c=>`${i(c.x).toFixed(1)} ${s(c.low).toFixed(1)}`);return`M${a.join("L")}L${l.join("L")}Z`}function Sa(n,e,t,i,s=as.muted){return je("text",{x:n,y:e,"text-anchor":i,fill:s,"font-size":11},t)}function Bb(n,e,t,i,s,r){let{xScale:o,yScale:a}=Ws(n,e),l=[],c=lo(t[0]*o.factor,t[1]*o.factor,8),u=lo(i[0]*a.factor,i[1]*a.factor,5);pa(c).forEach((h,f)=>{let p=s(c[f]/o.factor);l.push(je("path",{d:`M${p} ${Xs}V${Ms-Pr}`,stroke:as.grid})),l.push(Sa(p,Ms-Pr+14,h,"middle"))}),pa(u).forEach((h,f)=>{let p=r(u[f]/a.factor);l.push(je("path",{d:`M${qs} ${p}H${vo-wa}`,stroke:as.grid})),l.push(Sa(qs-6,p+4,h,"end"))}),l.push(Sa((qs+vo-wa)/2,Ms-6,Ma(n.xLabel,o),"middle"));let d=Sa(0,0,Ma(n.yLabel,a),"middle");return d.setAttribute("transform",`translate(12 ${(Xs+Ms-Pr)/2}) rotate(-90)`),l.push(d),l}function Tg(n,e,t,i){let s=Vs(n.curves),r=t??hn(s.x)??[0,1],o=Pl(n,...Xp(s,r[0],r[1],i)),a=p=>qs+(p-r[0])/(r[1]-r[0]||1)*(vo-qs-wa),l=p=>Ms-Pr-(p-o[0])/(o[1]-o[0]||1)*(Ms-Xs-Pr),c=`clip-${n.id}`,u={x:qs,y:Xs,width:vo-qs-wa,height:Ms-Xs-Pr},d=Bb(n,e,r,o,a,l),h=je("g",{"clip-path":`url(#${c})`,fill:"none"});if(n.window){let p=a(n.window.from);h.append(je("rect",{x:p,y:Xs,width:Math.max(0,a(n.window.to)-p),height:u.height,fill:as.window}))}n.band&&h.append(je("path",{d:kb(s,n.band.low,n.band.high,a,l),fill:as.band})),n.curves.forEach((p,v)=>{if(i.has(v))return;let g=as.curve[p.role];if(p.points){p.x.forEach((A,b)=>{let C=p.y[b];A===null||C===null||C===void 0||h.append(je("circle",{cx:a(A),cy:l(C),r:2.4,fill:as.paper,stroke:g}))});return}let m=oo[p.role].join(" ")||null,S=Ob(s,v,r[0],r[1],a,l);h.append(je("path",{d:S,stroke:g,"stroke-width":ao[p.role]*.75,"stroke-dasharray":m}))});for(let{value:p}of Sr(n))h.append(je("path",{d:`M${qs} ${l(p)}H${vo-wa}`,stroke:as.limit,"stroke-width":1.5}));(n.events??[]).forEach((p,v)=>{p.x<r[0]||p.x>r[1]||(h.append(je("path",{d:`M${a(p.x)} ${Xs}V${Ms-Pr}`,stroke:as.event,"stroke-dasharray":"2 3"})),d.push(Sa(a(p.x),Xs-4,String(v+1),"middle",as.event)))});let f={viewBox:`0 0 ${vo} ${Ms}`,class:"paper-figure",role:"img","aria-label":n.title};return je("svg",f,je("clipPath",{id:c},je("rect",u)),...d,h)}function Eg(n,e){let{xScale:t,yScale:i}=Ws(n,e),s=Vs(n.curves),r=[{label:n.xLabel,unit:t.symbol},...n.curves.map(a=>({label:a.label,unit:i.symbol}))],o=s.x.map((a,l)=>[a*t.factor,...s.y.map(c=>{let u=c[l];return typeof u=="number"?u*i.factor:u})]);return{name:`hawser-${n.id}`,columns:r,rows:o}}var Vb=400;function zb(n){if(n==null)return"";if(typeof n=="number")return Number.isFinite(n)?String(Number(n.toPrecision(12))):"";let e=/^[=+\-@]/.test(n)?`'${n}`:n;return/[",\r\n]/.test(e)?`"${e.replaceAll('"','""')}"`:e}var Cg=n=>n.unit?`${n.label}, ${n.unit}`:n.label;function Ag(n){return[n.columns.map(Cg),...n.rows].map(t=>t.map(zb).join(",")).join(`\r
`)+`\r
`}async function Gb(n){try{return await navigator.clipboard.writeText(n),!0}catch{let e=P("textarea",{class:"offscreen",readonly:!0});e.value=n,document.body.append(e),e.select();let t=document.execCommand("copy");return e.remove(),t}}function Hb(n,e){let t=URL.createObjectURL(new Blob([e],{type:"text/csv"}));P("a",{href:t,download:`${n}.csv`}).click(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}function Ed(n,e,t=6){let i=n.rows.slice(0,Vb),r=n.rows.length>i.length?` (the first ${i.length} of ${n.rows.length} rows; the CSV has all)`:"",o=i.map(l=>P("tr",{},...l.map(c=>typeof c=="number"?P("td",{class:"number"},dn(c,t)):P("td",{},c===null?ai:ft(c??""))))),a=P("tr",{},...n.columns.map(l=>P("th",{scope:"col"},Cg(l))));return P("div",{class:"scroll",tabindex:0,role:"region","aria-label":e},P("table",{class:"data"},P("caption",{},e+r),P("thead",{},a),P("tbody",{},...o)))}function Xi(n){let e=P("span",{class:"said",role:"status"}),t=ei("Copy CSV",()=>{Gb(Ag(n())).then(s=>{e.textContent=s?"copied":"the browser does not allow copying",setTimeout(()=>e.textContent="",4e3)})}),i=ei("Save CSV",()=>{let s=n();Hb(s.name,Ag(s))});return P("div",{class:"tools"},t,i,e)}function Yl(n,e,t,i){let s=P("div",{class:"behind"}),r=l=>{o.setAttribute("aria-expanded",String(l)),o.textContent=l?"Hide table":"Table",s.replaceChildren(...l?[Ed(n(),e)]:[])},o=ei("Table",()=>{let l=o.getAttribute("aria-expanded")!=="true";r(l),i(l)});r(t);let a=Xi(n);return a.prepend(o),[a,s]}var Wb="Arrow keys move the cursor, plus and minus zoom, 0 shows all.";function Xb(n,e){let{yScale:t}=Ws(n,e.get("units")),i=n.curves.filter(s=>!s.quiet).map(s=>{let r=hn(s.y);if(!r)return`${s.label}: nothing known`;let[o,a]=r.map(l=>(l*t.factor).toPrecision(4));return`${s.label}: from ${o} to ${a} ${t.symbol}`});return`${n.title}. ${i.join("; ")}. ${Wb}`}var bo=class{constructor(e,t,i){this.spec=e;this.store=t;this.memory=i;this.frame=P("div",{class:"frame",tabindex:0,role:"group","aria-roledescription":"figure","aria-label":Xb(e,t)},this.root),this.frame.addEventListener("keydown",c=>this.key(c));let r=Yl(()=>Eg(e,t.get("units")),e.title,i.open,c=>i.open=c),o=P("figcaption",{},P("p",{class:"caption"},e.caption),...r);this.element=P("figure",{id:`figure-${e.id}`,class:"figure"},P("h3",{},e.title),this.legendRoot,this.frame,this.paper,this.said,o);for(let c of["place","time"])this.ends.push(t.subscribe(c,(u,d)=>d!==this&&this.follow()));let a=new ResizeObserver(()=>this.resize());a.observe(this.frame);let l=()=>{this.wanted=!0,this.resize()};this.ends.push(()=>a.disconnect(),Al(this.element,l)),this.drawLegend(t.get("theme"))}spec;store;memory;element;root=P("div",{class:"plot"});frame;paper=P("div",{class:"on-paper"});said=P("p",{class:"offscreen",role:"status"});legendRoot=P("div");ends=[];plot=null;wanted=!1;legend=null;dispose(){for(let e of this.ends)e();this.plot?.chart.destroy(),this.plot=null}print(e){let{spec:t,store:i,memory:s}=this;this.drawLegend(e?"light":i.get("theme")),this.paper.replaceChildren(...e?[Tg(t,i.get("units"),s.zoom,s.hidden)]:[])}width(){return Math.max(240,Math.floor(this.frame.clientWidth)-2)}resize(){let e=this.spec.height??(this.width()<560?220:280);this.frame.clientWidth!==0&&(this.root.style.minHeight=`${e}px`,this.wanted&&(this.plot&&this.plot.chart.width===this.width()||(this.plot?this.plot.chart.setSize({width:this.width(),height:e}):this.draw(e),this.follow())))}draw(e){let{spec:t,store:i,memory:s}=this;this.plot?.chart.destroy(),this.plot=wg(this.root,t,{width:this.width(),height:e,theme:i.get("theme"),units:i.get("units"),hidden:s.hidden,zoom:s.zoom,onCursor:r=>this.point(r),onZoom:r=>this.remember(r)}),this.drawLegend(i.get("theme"))}drawLegend(e){let{spec:t,store:i,memory:s}=this,r=i.get("units"),o=this.plot?.aligned??Vs(t.curves);this.legend=$p(t,o,Ws(t,r).yScale,{theme:e,units:r,hidden:s.hidden,onToggle:a=>this.toggle(a)}),this.legendRoot.replaceChildren(this.legend.element)}toggle(e){let{hidden:t}=this.memory;t.delete(e)||t.add(e),this.plot&&this.draw(this.plot.chart.height);let i=this.legendRoot.querySelectorAll("button"),s=this.spec.curves.map((r,o)=>o).filter(r=>!this.spec.curves[r]?.quiet);i[s.indexOf(e)]?.focus(),this.follow()}remember(e){let t=this.plot?.reach??e,i=(t[1]-t[0])*1e-6,s=e[0]<=t[0]+i&&e[1]>=t[1]-i;this.memory.zoom=s?null:e,this.element.classList.toggle("zoomed",!s)}point(e){this.legend?.update(e??Ll(this.spec,this.store)),Yh(this.spec,this.store,e,this)}follow(){let e=Ll(this.spec,this.store);this.plot&&Yp(this.plot,e),this.legend?.update(e)}key(e){let{plot:t,spec:i,store:s}=this;if(!t||e.target!==this.frame)return;let{factor:r}=t.xScale;Zp(e,{reach:()=>t.reach,view:()=>this.memory.zoom??t.reach,cursor:()=>Ll(i,s),move:o=>{Yh(i,s,o,null),this.said.textContent=this.legend?.sentence()??""},zoom:([o,a])=>{t.chart.setScale("x",{min:o*r,max:a*r}),this.follow()}})}};var Mo=class{constructor(e){this.state=e}state;listeners=new Map;get(e){return this.state[e]}set(e,t,i=null){if(Object.is(this.state[e],t))return;this.state[e]=t;let s=this.listeners.get(e);for(let r of[...s??[]])r(t,i)}subscribe(e,t){let i=this.listeners.get(e)??new Set;return i.add(t),this.listeners.set(e,i),()=>{i.delete(t)}}};var Rg=()=>new Promise(n=>{let{port1:e,port2:t}=new MessageChannel;e.onmessage=()=>{e.close(),n()},t.postMessage(0)});async function qb(n){let e=n.endsWith("==")?2:n.endsWith("=")?1:0,t=new Uint8Array(n.length/4*3-e),i=0;for(let s=0;s<n.length;s+=1048576){let r=atob(n.slice(s,s+1048576));for(let o=0;o<r.length;o++)t[i++]=r.charCodeAt(o);s+1048576<n.length&&await Rg()}return t}async function $b(n){let e=new Blob([n]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(e).arrayBuffer())}async function Zl(n,e,t,i){let s=e*t*i,r=await $b(await qb(n));if(r.length!==4*s)throw new Error(`a field has ${r.length} bytes, not ${4*s}`);let o=new Int32Array(s),a=t*i,l=performance.now();for(let c=0;c<e;c++)Yb(r,o,s,c*a,a,i),performance.now()-l>6&&(await Rg(),l=performance.now());return o}function Yb(n,e,t,i,s,r){let o=i===0;for(let a=0;a<s;a++){let l=i+a,c=n[l]|n[l+t]<<8|n[l+2*t]<<16|n[l+3*t]<<24,u=c>>>1^-(c&1);a>=r&&(u+=e[l-r]-(o?0:e[l-s-r])),o||(u+=e[l-s]),e[l]=u}}function Ad(n,e){let t=0,i=n.length-1;for(;t<i;){let s=t+i+1>>1;n[s]<=e?t=s:i=s-1}return t}var Ir=class{constructor(e,t){this.items=t;this.time=Float64Array.from(e)}items;time;fields=new Map;get count(){return this.time.length}get from(){return this.time[0]??0}get to(){return this.time[this.count-1]??0}between(e){let t=Ad(this.time,e),i=Math.min(t+1,this.count-1),s=this.time[i]-this.time[t];return{frame:t,next:i,part:s>0?Math.min(1,Math.max(0,(e-this.time[t])/s)):0}}sample(e,t,i,s=[]){let r=this.fields.get(e);if(!r)return!1;let{components:o,step:a}=r.meta,l=this.items*o,c=t.frame*l,u=t.next*l,d=r.q;for(let h=0;h<o;h++){let f=s[h]??0;for(let p=h;p<l;p+=o){let v=d[c+p];i[p]=a*(v+t.part*(d[u+p]-v))-f}}return!0}timeOfLargest(e){let t=this.fields.get(e)?.q;if(!t||t.length===0)return null;let i=t.reduce((s,r,o)=>r>t[s]?o:s,0);return this.time[Math.floor(i/this.items)]??null}history(e,t){let i=this.fields.get(e);if(!i)return null;let{components:s,step:r}=i.meta;return Float64Array.from(this.time,(o,a)=>{let l=(a*this.items+t(a))*s,c=0;if(s===1)return r*i.q[l];for(let u=0;u<s;u++)c+=i.q[l+u]**2;return r*Math.sqrt(c)})}};async function Cd(n,e){let t=new Ir(n.time_s,n.segments),i=Object.keys(n.packed).sort((s,r)=>+(r==="position")-+(s==="position"));for(let s of i){let r=n.fields[s];if(!r)continue;let o=await Zl(n.packed[s],n.frames,n.segments,r.components);t.fields.set(s,{meta:r,q:o}),e(t,s)}return t}var vt=(n,e)=>[n[0]-e[0],n[1]-e[1],n[2]-e[2]],Bt=(n,e,t=1)=>[n[0]+t*e[0],n[1]+t*e[1],n[2]+t*e[2]],zn=(n,e)=>n[0]*e[0]+n[1]*e[1]+n[2]*e[2],bi=(n,e)=>[n[1]*e[2]-n[2]*e[1],n[2]*e[0]-n[0]*e[2],n[0]*e[1]-n[1]*e[0]],ni=n=>Math.hypot(n[0],n[1],n[2]);function Lt(n,e=[1,0,0]){let t=ni(n);return t>1e-12?[n[0]/t,n[1]/t,n[2]/t]:e}var Kl=class{constructor(e,t){this.s=e;this.points=t;this.along=t.slice(1).map((i,s)=>Lt(vt(i,t[s])))}s;points;along;get from(){return this.s[0]??0}get to(){return this.s[this.points.length-1]??0}piece(e){return Math.max(0,Math.min(this.points.length-2,Ad(this.s,e)))}at(e){let t=this.piece(e),i=this.s[t+1]-this.s[t],s=(e-this.s[t])/i;if(s>=0&&s<=1)return Bt(this.points[t],vt(this.points[t+1],this.points[t]),s);let r=s<0?t:t+1;return Bt(this.points[r],this.along[t],e-this.s[r])}tangent(e){return this.along[this.piece(e)]??[1,0,0]}nearest([e,t,i]){let{s,points:r,along:o}=this,a=1/0,l=this.from;for(let c=0;c+1<r.length;c++){let u=r[c],d=o[c],h=e-u[0],f=t-u[1],p=i-u[2],v=s[c+1]-s[c],g=Math.min(v,Math.max(0,h*d[0]+f*d[1]+p*d[2])),m=(h-g*d[0])**2+(f-g*d[1])**2+(p-g*d[2])**2;m<a&&(a=m,l=s[c]+g)}return{s:l,distance:Math.sqrt(a)}}};var So=[0,0,1],Rd=n=>n*Math.PI/180;function Jl(n){let e=Math.max(1,n.length),t=n.reduce((c,u)=>Bt(c,u,1/e),[0,0,0]),i=0,s=0,r=0;for(let c of n){let[u,d]=vt(c,t);i+=u*u,s+=u*d,r+=d*d}let o=.5*Math.atan2(2*s,i-r),a=[Math.cos(o),Math.sin(o),0],l=n.length>1?vt(n[e-1],n[0]):a;return zn(l,a)<0?[-a[0],-a[1],0]:a}function jl(n,e,t,i,s=.12){let r=Lt(bi(So,e),[0,1,0]),o=bi(e,r),a=Math.tan(Rd(t)/2)*(1-s),l=Zb(n,[r,o,e]),c=0;for(let u=0;u<4;u++){c=1;for(let f of n){let p=vt(f,l),v=Math.max(Math.abs(zn(p,r))/(a*i),Math.abs(zn(p,o))/a);c=Math.max(c,zn(p,e)+v)}let d=n.map(f=>{let p=vt(f,l),v=Math.max(1e-6,c-zn(p,e));return[zn(p,r)/v,zn(p,o)/v]}),h=f=>{let p=d.map(v=>v[f]);return .5*(p.reduce((v,g)=>Math.min(v,g))+p.reduce((v,g)=>Math.max(v,g)))};l=Bt(Bt(l,r,h(0)*c),o,h(1)*c)}return{position:Bt(l,e,c),target:l,fov:t}}function Zb(n,e){return e.reduce((t,i)=>{let s=n.map(a=>zn(a,i)),r=s.reduce((a,l)=>Math.min(a,l),1/0),o=s.reduce((a,l)=>Math.max(a,l),-1/0);return Bt(t,i,.5*(r+o))},[0,0,0])}function Ql(n,e){let t=bi(n,So);return Lt(Bt([0,0,Math.sin(Rd(e))],t,Math.cos(Rd(e))))}var Pg=(n,e)=>jl(n,Ql(Jl(n),32),35,e),Ig=(n,e)=>jl(n,Ql(Jl(n),89.9),20,e),Lg=(n,e)=>jl(n,Ql(Jl(n),2),20,e);function Ng(n,e,t){let i=n.tangent(e),s=Lt(bi(i,So),[0,1,0]),r=Lt([i[0],i[1],0],i),o=n.at(e);return{position:Bt(Bt(Bt(o,r,-t),s,.35*t),So,.4*t),target:o,fov:50}}function Dg(n,e,t){let i=e.to-e.from,s=Math.max(.5,.15*i),r=Math.max(n.from,e.from-s),o=Math.min(n.to,e.to+s),a=Array.from({length:33},(h,f)=>n.at(r+(o-r)*f/32)),l=vt(n.tangent(e.to+1e-6),n.tangent(Math.max(n.from,e.from-1e-6))),c=Math.abs(l[2])>Math.hypot(l[0],l[1]),u=ni(vt(a[32],a[0]))*.03,d=a.flatMap(h=>[Bt(h,So,u),Bt(h,So,-u)]);return jl(d,Ql(Jl(a),c?12:48),35,t)}function Fg(n,e,t){let i=t*t*(3-2*t);return{position:Bt(n.position,vt(e.position,n.position),i),target:Bt(n.target,vt(e.target,n.target),i),fov:n.fov+(e.fov-n.fov)*i}}function wo(n,e,t){let i=Lt(vt(n.position,n.target));return{position:Bt(e,i,t),target:e,fov:n.fov}}var Kb=60,Pd=n=>Math.max(2.5,40*n.diameter),ec=class{constructor(e,t,i){this.world=e;this.now=t;this.time=i}world;now;time;followed=null;atBend=-1;onChange=()=>{};get model(){return this.world.model}changed(){this.onChange(this.atBend<0?null:this.atBend,this.followed!==null)}preset(e,t,i=!1){let{extent:s}=this.model,{stage:r}=this.world,o=[()=>Pg(s,r.aspect),()=>this.behind(t),()=>Ig(s,r.aspect),()=>Lg(s,r.aspect)];e!==1&&(this.followed=null),this.atBend=-1,r.go(o[e](),i),this.changed()}behind(e){let{model:t}=this,i=this.now();if(!t.path)return wo(this.world.stage.pose,i?.centre(t.head)??[0,0,0],Pd(t));let s=i?.headPlace(this.time())??t.path.from;return Ng(t.path,e??Math.min(t.path.to,s),Pd(t))}bend(e){let{bends:t,path:i}=this.model,s=t[e];!i||!s||(this.followed=null,this.atBend=e,this.world.stage.go(Dg(i,s,this.world.stage.aspect)),this.changed())}nextBend(e){let t=this.model.bends.length;t>0&&this.bend((this.atBend+e+(this.atBend<0&&e<0?1:0)+t)%t)}follow(e=!this.followed){let t=this.now(),{stage:i}=this.world;this.followed=e&&t?t.centre(this.model.head):null,this.followed&&i.go(wo(i.pose,this.followed,Math.min(i.distance,Kb))),this.changed()}goWithHead(e){if(!this.followed)return;let t=e.centre(this.model.head);this.world.stage.shift(vt(t,this.followed)),this.followed=t}lookAt(e){let{stage:t}=this.world;t.go(wo(t.goal,e,Pd(this.model)*2))}};var Id=[{field:"tension",title:"Tension",unit:"N"},{field:"sidewall",title:"Sidewall pressure",unit:"N/m"},{field:"curvature",title:"Curvature",unit:"1/m"},{field:"speed",title:"Speed",unit:"m/s"},{field:"contact",title:"Contact force per length",unit:"N/m"}];function Di(n,e){let{symbol:t,factor:i}=kt("m",e,n);return`${(n*i).toFixed(1).replace("-","\u2212")}\xA0${t}`}function Ta(n,e){if(e<600)return`${n.toFixed(1)}\xA0s`;let t=s=>String(Math.floor(s)).padStart(2,"0"),i=t(n%60);return e<3600?`${Math.floor(n/60)}:${i}\xA0min`:`${Math.floor(n/3600)}:${t(n/60%60)}:${i}\xA0h`}var Ug=.001,Jb=1.5*Math.PI/180,jb=.5,Qb=.4;function Og(n){return n.map((e,t)=>{let[i,s]=[n[t-1],n[t+1]];return i&&s?bi(Lt(vt(e,i)),Lt(vt(s,e))):[0,0,0]})}function kg(n,e,t=[]){let i=[],s=null,r=null,o=()=>{s&&s.angle>=Jb&&i.push({...s,number:i.length+1}),s=r=null};for(let a=0;a<n.length;a++){let l=Math.abs(e[a]??0);if(!(l>=Ug&&a+1<n.length)){o();continue}let u=t[a+1];u&&ni(u)>Qb*l*(n[a+1]-n[a])&&(r&&zn(Lt(u),r)<jb&&o(),r=Lt(u));let d=Math.abs(e[a+1]??0),h=d>=Ug?.5*(l+d):l;s??={number:0,from:n[a],to:n[a],radius:1/0,angle:0},s.to=n[a+1],s.angle+=h*(s.to-n[a]),s.radius=Math.min(s.radius,1/l)}return i}function tc(n,e){let t=(n.angle*180/Math.PI).toFixed(0);return`Bend ${n.number}: ${t}\xB0, R ${Di(n.radius,e)}`}var ic=[{name:"Overview",key:"1",title:"The whole route"},{name:"Along",key:"2",title:"Behind the head, along the cable"},{name:"Plan",key:"3",title:"From above"},{name:"Profile",key:"4",title:"From the side"}],Ea=5,Vg=5,zg=100,Gg=100,nc=class{constructor(e,t,i){this.bends=e;let s=ic.map(({name:r,key:o,title:a},l)=>ei(r,()=>i.preset(l),{title:`${a} (${o})`,"aria-keyshortcuts":o}));this.bendList=P("select",{"aria-label":"Go to a bend",hidden:e.length===0}),this.bendList.addEventListener("change",()=>{this.bendList.value&&i.bend(Number(this.bendList.value))}),this.colours=P("select",{},...t.map(({field:r,title:o})=>P("option",{value:r},o))),this.colours.addEventListener("change",()=>i.colour(this.colours.value)),this.slider.setAttribute("aria-label","Diameter drawn, times the true one"),this.slider.addEventListener("input",()=>{let r=this.slider.valueAsNumber;this.slider.setAttribute("aria-valuetext",r===0?"as suits the view":`times ${Bg(r).toFixed(1)}`),i.factor(r===0?null:Bg(r))}),this.root=P("div",{class:"view-tools"},P("div",{class:"view-presets",role:"group","aria-label":"Camera"},...s,this.bendList),P("label",{class:"view-field"},"Colour",this.colours),P("label",{class:"view-field",title:"Left end: as suits the view"},"Diameter: auto",this.slider,`\xD7${zg}`)),this.units("si")}bends;root;bendList;colours;slider=P("input",{type:"range",min:0,max:Gg,step:1,value:0,class:"view-thick"});units(e){let t=this.bends.map((i,s)=>P("option",{value:s},tc(i,e)));this.bendList.replaceChildren(P("option",{value:""},"Bend\u2026"),...t)}coloured(e){this.colours.value=e}atBend(e){this.bendList.value=e===null?"":String(e)}},Bg=n=>zg**((n-1)/(Gg-1));var Hg=[["Space","play, pause"],["\u2190 \u2192","frame by frame (Shift: ten)"],["Home End","first, last"],[", .","slower, faster"],["+ \u2212","zoom"],["W A S D","turn"],[`1\u2013${ic.length}`,"overview, along, plan, profile"],[`${Ea}\u20139`,"bends"],["B","next bend"],["E","next event"],["F","follow the head"],["C","next colour"],["Z","zoom to the place"],["Esc","clear the choice"]];function eM(n,e,t){let i=e?10:1,s=e?-1:1,r=/^[1-9]$/.test(n)?Number(n):0;return r>0&&r<=ic.length?()=>t.preset(r-1):r>=Ea&&r<Ea+Vg?()=>t.bend(r-Ea):{" ":()=>t.toggle(),arrowleft:()=>t.step(-i),arrowright:()=>t.step(i),home:()=>t.end(!1),end:()=>t.end(!0),",":()=>t.faster(-1),".":()=>t.faster(1),"+":()=>t.zoom(1/1.3),"=":()=>t.zoom(1/1.3),"-":()=>t.zoom(1.3),w:()=>t.orbit(0,5),s:()=>t.orbit(0,-5),a:()=>t.orbit(-5,0),d:()=>t.orbit(5,0),b:()=>t.nextBend(s),e:()=>t.event(s),f:()=>t.follow(),c:()=>t.nextColour(),z:()=>t.toPlace(),escape:()=>t.leave()}[n.toLowerCase()]??null}function tM(n,e){return n instanceof HTMLSelectElement?e!=="Escape":n instanceof HTMLButtonElement?e===" "||e==="Enter":n instanceof HTMLInputElement?n.type==="checkbox"?e===" ":!n.classList.contains("view-time")&&/^(Arrow|Home|End)/.test(e):!1}function Wg(n,e){let t=i=>{if(i.ctrlKey||i.metaKey||i.altKey||tM(i.target,i.key))return;let s=eM(i.key,i.shiftKey,e);s&&(i.preventDefault(),s())};return n.addEventListener("keydown",t),()=>n.removeEventListener("keydown",t)}var Xg="force";async function qg(n){let e=n.roller_force,t=n.geometry?.rollers.length??0,i=n.states?.time_s??[];if(!e||t===0)return null;let s=new Ir(i,t);return s.fields.set(Xg,{meta:e,q:await Zl(e.packed,i.length,t,e.components)}),s}function nM(n,e){let t=n.series?.[`load_${e}_N`],i=n.series?.time_s;return!Array.isArray(t)||!Array.isArray(i)?null:{time:i.map(Number),values:t.map(s=>typeof s=="number"?s:NaN)}}var $g=(n,e)=>Float64Array.from(n,t=>t*e);function Yg(n,e,t,i){let s=n.run.geometry?.rollers[e];if(!s)return null;let r=nM(n.run,s.name),o=r?.values??t?.history(Xg,()=>e)??[],a=r?.time??t?.time??[],l=n.run.rollers,c=l?.name?.indexOf(s.name)??-1,u=m=>{let S=c>=0?l?.[m]?.[c]:null;return typeof S=="number"?S:null},d=u("peak_N"),h=[s.s_m===null?s.kind:`${s.kind} at ${Di(s.s_m,i)}`];for(let[m,S]of[["steady","steady_N"],["peak","peak_N"]]){let A=u(S);A!==null&&h.push(`${m} ${Qe(A,"N",i,3)}`)}s.rating_N!==null&&h.push(`may carry ${Qe(s.rating_N,"N",i,3)}`);let f=Array.from(o).reduce((m,S)=>S>m?S:m,d??0),{symbol:p,factor:v}=kt("N",i,f),g=s.rating_N!==null&&s.rating_N<4*f?{label:"rating",value:s.rating_N*v}:void 0;return{title:s.name,facts:h,label:`load, ${p}`,time:a,values:$g(o,v),limit:g}}var iM=1.5;function Zg(n,e,t,i,s){if(!n.path||!n.chain)return null;let r=n.chain.length_m.reduce((p,v)=>Math.max(p,v),0),o=t.segmentsAt(n.path.at(e),Math.max(1,iM*r)),a=t.frames.history(i.field,p=>Math.max(0,o[p])),l=a?a.map((p,v)=>o[v]<0?NaN:p):[],c=Array.from(l).filter(p=>Number.isFinite(p)),u=c.reduce((p,v)=>Math.max(p,v),-1/0),{symbol:d,factor:h}=kt(i.unit,s,Math.max(Math.abs(u),0)),f=c.length>0?[]:["nothing passes there"];return c.length>0&&f.push(`largest ${Qe(u,i.unit,s,3)}`),{title:`Place ${Di(e,s)}`,facts:f,label:`${i.title.toLowerCase()}${d?`, ${d}`:""}`,time:t.frames.time,values:$g(l,h)}}function rc(n,e,t){let i=n.headPlace(),s=n.largestTension,r=s?e.path?.nearest(n.centre(s.segment)):void 0,o=[`At ${Ta(n.time,n.frames.to)}`],a=[i===null?"the head is off the route":`the head is at ${Di(i,t)}`];if(s&&s.value>0){let l=!r||r.distance>3?"off the route":`at ${Di(r.s,t)}`;a.push(`the largest tension is ${Qe(s.value,"N",t,3)} ${l}`)}return`${o.join("")} ${a.join(", ")}.`}var sc=class{constructor(e,t){this.visible=e;this.spoken=t}visible;spoken;timer=0;last=0;tell(e,t){let i=performance.now();(i-this.last>200||!t)&&(this.visible.textContent=e(),this.last=i),clearTimeout(this.timer),this.timer=window.setTimeout(()=>this.spoken.textContent=e(),sM)}dispose(){clearTimeout(this.timer)}},sM=700;var rM=2,oM={"font-size":12,"text-anchor":"middle","paint-order":"stroke",stroke:"#fff","stroke-width":4};function aM(n,e,t,i){let s=e.shown().flatMap(({text:o,x:a,y:l,aside:c})=>[je("circle",{cx:a,cy:l,r:2,fill:"#000"}),je("text",{x:a+c,y:l-10,...oM},o)]),r=je("image",{href:n,width:t,height:i});return je("svg",{viewBox:`0 0 ${t} ${i}`,class:"view-still",role:"img"},r,...s)}function Kg(n,e){let{world:t,now:i,playback:s,model:r}=n,o=i?.frames.timeOfLargest("tension")??null;if(!t||!i||o===null)return null;let{stage:a}=t,l={time:s.time,pose:a.goal};t.paint("light"),n.preset(0,!0),n.showAt(o);let c=a.shot(rM),u=aM(c,t.labels,a.width,a.height),d=rc(i,r,e.get("units")),h=n.legend.root.cloneNode(!0);return t.paint(e.get("theme")),n.showAt(l.time),a.go(l.pose,!0),P("div",{class:"view-paper view3d"},u,h,P("p",{class:"caption"},d))}function Jg(n,e){let t=null,i=0,s=null,r=l=>{let c=n.getBoundingClientRect();return{x:l.clientX-c.left,y:l.clientY-c.top}},o=()=>{i=0,s&&e.hover(s.x,s.y)},a={pointerdown:l=>t=r(l),pointermove:l=>{s=l.buttons===0?r(l):null,i||=requestAnimationFrame(o)},pointerleave:()=>{s=null,e.leave()},click:l=>{let{x:c,y:u}=r(l);t&&Math.hypot(c-t.x,u-t.y)<4&&e.click(c,u)},dblclick:l=>{let{x:c,y:u}=r(l);e.double(c,u)}};for(let[l,c]of Object.entries(a))n.addEventListener(l,c);return()=>{cancelAnimationFrame(i);for(let[l,c]of Object.entries(a))n.removeEventListener(l,c)}}var jg=.05,Qg=200;function lM(n){let e=n.chain?.segments??n.states?.segments??0;if(e===0)return null;let t=n.chain;return{segments:e,length_m:t?.length_m??new Array(e).fill(1),diameter_m:t?.diameter_m??new Array(e).fill(jg),part:t?.part??new Array(e).fill(0)}}function oc(n){let e=n.geometry??null,t=e?.route.position_m??[],i=d=>{let h=t.map(v=>v[d]),f=h.reduce((v,g)=>Math.min(v,g),1/0),p=h.reduce((v,g)=>Math.max(v,g),-1/0);return h.length>0?.5*(f+p):0},s=[i(0),i(1),i(2)],r=d=>vt(d,s),o=t.map(r),a=lM(n),l=a?a.part.lastIndexOf(0):-1,c=Math.max(1,Math.floor(o.length/Qg)),u=o.filter((d,h)=>h%c===0||h===o.length-1);if(e?.reel&&u.push(r(e.reel.center_m)),e?.winch&&cM(o,r(e.winch.position_m))&&u.push(r(e.winch.position_m)),u.length===0){let d=a?a.length_m.reduce((h,f)=>h+f,0):1;u.push([-d,0,0],[d,0,0])}return{run:n,centre:s,at:r,path:e&&o.length>1?new Kl(e.route.s_m,o):null,bends:e?kg(e.route.s_m,e.route.curvature_per_m,Og(o)):[],chain:a,head:a?l>=0?l:a.segments-1:0,diameter:a?.diameter_m[Math.max(0,l)]??jg,extent:u}}function cM(n,e){let t=n[n.length-1];return!!t&&ni(vt(e,t))<.5*ni(vt(t,n[0]))}function e0(n,e){let t=n.fields.get("position");if(!t||e.path)return;let i=[];for(let r=0;r<n.items;r+=Math.max(1,Math.floor(n.items/Qg)))i.push([0,1,2].map(o=>t.q[3*r+o]*t.meta.step));i.reduce((r,o)=>[r[0]+o[0],r[1]+o[1],r[2]+o[2]],[0,0,0]).forEach((r,o)=>e.centre[o]=r/i.length),e.extent=i.map(e.at)}function t0(n){let e=n.run.geometry?.reel;if(!e)return()=>!1;let[t,i,s]=n.at(e.center_m),[r,o,a]=Ld(e.axis);return(l,c,u)=>{let d=(l-t)*r+(c-i)*o+(u-s)*a,h=(l-t)**2+(c-i)**2+(u-s)**2-d*d;return Math.abs(d)<.6*e.width_m+.2&&h<(1.02*e.radius_m)**2}}var Ld=n=>Lt(n,[0,1,0]);var To=class{constructor(e,t){this.frames=e;this.model=t;this.centres=new Float32Array(3*e.items),this.values=new Float32Array(e.items),this.tension=new Float32Array(e.items)}frames;model;centres;values;tension;time=0;show(e,t){let i=this.frames.between(e);return this.frames.sample("position",i,this.centres,this.model.centre)?(this.frames.sample(t,i,this.values)||this.values.fill(0),this.frames.sample("tension",i,this.tension),this.time=e,!0):!1}centre(e){let t=this.centres;return[t[3*e],t[3*e+1],t[3*e+2]]}get largestTension(){if(!this.frames.fields.has("tension"))return null;let e=0;for(let t=1;t<this.tension.length;t++)this.tension[t]>this.tension[e]&&(e=t);return{segment:e,value:this.tension[e]}}headPlace(e=this.time){let t=this.model.run.states?.head_at_m??[],{frame:i,next:s,part:r}=this.frames.between(e),o=t[i]??null,a=t[s]??null;return o!==null&&a!==null?o+r*(a-o):this.model.path?.nearest(this.centre(this.model.head)).s??null}segmentsAt(e,t){let i=this.frames.fields.get("position"),s=new Int32Array(this.frames.count).fill(-1);if(!i)return s;let{q:r,meta:o}=i,[a,l,c]=e.map((d,h)=>(d+this.model.centre[h])/o.step),u=3*this.frames.items;for(let d=0;d<this.frames.count;d++){let h=(t/o.step)**2;for(let f=0,p=d*u;f<this.frames.items;f++,p+=3){let v=(r[p]-a)**2+(r[p+1]-l)**2+(r[p+2]-c)**2;v<h&&(h=v,s[d]=f)}}return s}};var ac=class{constructor(e,t){this.runs=e;this.models=e.map(i=>({...oc(i),centre:t.centre,at:t.at})),this.nows=e.map(()=>null)}runs;models;nows;arrived(e,t){this.nows[e]??=new To(t,this.models[e])}show(e,t){for(let i of this.nows)i?.show(e,t)}};function n0(n,e,t=()=>!1){let i=n.fields.get(e);if(!i)return null;let{q:s,meta:r}=i,o=1/0,a=-1/0,l=m=>{for(let S=0;S<n.count;S++)for(let A=0;A<n.items;A++)t(A,S)||m(s[S*n.items+A])};if(l(m=>{m<o&&(o=m),m>a&&(a=m)}),o>a)return null;let c=new Uint32Array(2048),u=0,d=Math.max(1,a-o)/2047;l(m=>{c[Math.floor((m-o)/d)]++,u++});let h=0;for(let m=c[0];m<.998*u&&h<2047;)m+=c[++h];let f=o+(h+1)*d,p=a>0&&a-o>2*(f-o),v=Math.min(0,o)*r.step,g=(p?f:a)*r.step;return{low:v,high:g>v?g:v+r.step,beyond:p?a*r.step:null}}function lc(n,e,t){let i=(e-n)/Math.max(1,t);if(!(i>0))return[];let s=10**Math.floor(Math.log10(i)),r=s*([1,2,5,10].find(a=>a*s>=i)??10),o=[];for(let a=Math.ceil(n/r-1e-9)+0;a*r<=e*(1+1e-12)+1e-9*r;a++)o.push(a*r);return o}var cc=class{constructor(e){this.model=e;let t=e.run.states?.packed,i=Id.filter(({field:s})=>t&&s in t);this.choices=i.length>0?i:Id,this.quantity=this.choices[0]}model;choices;quantity;scales=new Map;grown(){this.scales.clear()}choose(e){this.quantity=this.choices.find(t=>t.field===e)??this.quantity}get next(){return this.choices[(this.choices.indexOf(this.quantity)+1)%this.choices.length]}scale(e){let{field:t}=this.quantity;return e?.fields.has(t)&&!this.scales.has(t)&&this.scales.set(t,n0(e,t,this.wound(e))),this.scales.get(t)??null}wound(e){let t=e.fields.get("position");if(!this.model.run.geometry?.reel||!t)return;let i=t0(this.model),[s,r,o]=this.model.centre,{q:a,meta:l}=t;return(c,u)=>{let d=3*(u*e.items+c);return i(a[d]*l.step-s,a[d+1]*l.step-r,a[d+2]*l.step-o)}}};var uM=116,hM="11px system-ui",dM={light:{text:"#3b4650",grid:"#d9dfe5",line:"#1f6f8b",limit:"#c2410c"},dark:{text:"#c3ccd5",grid:"#2d3742",line:"#4fb3d4",limit:"#f08c4a"}},uc=class{constructor(e,t){this.seek=e;this.close=t}seek;close;root=P("section",{class:"view-inspector","aria-label":"Picked in the picture",hidden:!0});plot=null;time=NaN;show(e,t){if(this.plot?.destroy(),this.plot=null,this.root.hidden=!e,!e)return;let i=P("div",{class:"view-inspector-figure"});this.root.replaceChildren(P("header",{},P("strong",{},P("bdi",{},e.title.slice(0,80))),ei("\xD7",this.close,{"aria-label":"Close",title:"Close (Esc)"})),P("p",{},e.facts.join(" \xB7 ")),P("p",{class:"view-inspector-label"},`${e.label}, over time, s`),i),Array.from(e.values).some(r=>Number.isFinite(r))?this.plot=this.draw(i,e,t):i.append(P("p",{},"No figures over time in these data."))}draw(e,t,i){let s=dM[i],r={stroke:s.text,grid:{stroke:s.grid,width:1},ticks:{stroke:s.grid,width:1},font:hM},o=Array.from(t.values,u=>Number.isFinite(u)?u:null),a=[Array.from(t.time),o],l=[{},{label:t.label,stroke:s.line,width:1.5,points:{show:!1}}];t.limit&&(a.push(o.map(()=>t.limit?.value??null)),l.push({label:t.limit.label,stroke:s.limit,width:1,dash:[6,4],points:{show:!1}}));let c=new wn({width:Math.max(200,e.clientWidth),height:uM,legend:{show:!1},cursor:{drag:{x:!1,y:!1},y:!1},scales:{x:{time:!1}},axes:[{...r,size:20,gap:2},{...r,size:46}],series:l,hooks:{draw:[u=>this.line(u,s.limit)]}},a,e);return c.over.addEventListener("click",u=>this.seek(c.posToVal(u.offsetX,"x"))),c}line(e,t){if(!Number.isFinite(this.time))return;let i=e.valToPos(this.time,"x",!0);e.ctx.save(),e.ctx.strokeStyle=t,e.ctx.beginPath(),e.ctx.moveTo(i,e.bbox.top),e.ctx.lineTo(i,e.bbox.top+e.bbox.height),e.ctx.stroke(),e.ctx.restore()}at(e){this.time=e,this.plot?.redraw(!1,!1)}dispose(){this.plot?.destroy()}};var hc=[4456788,4725356,4665213,4277383,3757708,3238030,2783374,2328718,2070667,2271364,3520377,5555560,8048977,10869558,13820443,16639781];function fM(n){let e=hc.length-1,t=Math.min(1,Math.max(0,Number.isNaN(n)?0:n))*e,i=Math.min(e-1,Math.floor(t)),s=t-i,r=hc[i],o=hc[i+1],a=l=>{let c=r>>l&255;return c+s*((o>>l&255)-c)};return[a(16),a(8),a(0)]}function i0(n){let e=new Uint8Array(4*n);for(let t=0;t<n;t++)e.set([...fM(t/(n-1)).map(Math.round),255],4*t);return e}function s0(n){let e=hc.map(t=>`#${t.toString(16).padStart(6,"0")}`);return`linear-gradient(${n}, ${e.join(", ")})`}var dc=class{title=P("div",{class:"view-legend-title"});bar=P("div",{class:"view-legend-bar"});ticks=P("div",{class:"view-legend-ticks"});beyond=P("div",{class:"view-legend-note"});factor=P("div",{class:"view-legend-note"});grid=P("div",{class:"view-legend-note"});root;constructor(){this.bar.style.background=s0("to right");let e=P("div",{class:"view-legend-scale"},this.bar,this.ticks);this.root=P("div",{class:"view-legend"},this.title,e,this.beyond,this.factor,this.grid)}scale(e,t,i){if(this.bar.hidden=this.ticks.hidden=!t,this.beyond.textContent="",!t){this.title.textContent=`${e.title}: not in these data`;return}let{symbol:s,factor:r}=kt(e.unit,i,t.high);this.title.textContent=`${e.title}, ${s}`;let o=t.low*r,a=t.high*r;this.ticks.replaceChildren(...lc(o,a,4).map(l=>{let c=P("span",{},dn(l,3));return c.style.left=`${100*(l-o)/(a-o)}%`,c})),t.beyond!==null&&(this.beyond.textContent=`single peaks to ${dn(t.beyond*r,3)} ${s} have the last colour`)}sizes(e,t,i){let s=e<10?e.toFixed(e<1.05?0:1).replace(".0",""):e.toFixed(0);this.factor.textContent=e<1.05?"true diameter":`diameter \xD7 ${s}, rollers and ducts with it`;let{symbol:r,factor:o}=kt("m",i,t);this.grid.textContent=`grid ${dn(t*o,3)} ${r}`}};var r0=10,o0=40,pM=n=>n.length>o0?`${n.slice(0,o0)}\u2026`:n;function a0(n,e,t){let{path:i,run:s,bends:r}=e,o=s.geometry,a=(l,c,u,d,h="name")=>n.set(l,{text:c,point:u,weight:d,kind:h});if(i){let{factor:l}=kt("m",t,1),c=lc(i.from*l,i.to*l,r0);for(let u=0;u<3*r0;u++){let d=(c[u]??0)/l,h=Di(d,t).replace(".0","");n.set(`distance${u}`,u<c.length?{text:h,point:i.at(d),weight:10,kind:"distance"}:null)}r.forEach((u,d)=>a(`bend${d}`,tc(u,t),i.at(.5*(u.from+u.to)),20+u.angle));for(let u of o?.conveyors??[])a(`conveyor ${u.name}`,pM(u.name),i.at(.5*(u.from_m+u.to_m)),40)}o?.reel&&a("reel","Reel",e.at(o.reel.center_m),60),o?.winch&&a("winch","Winch",e.at(o.winch.position_m),60)}var Ss=[.1,.25,.5,1,2,5,10,20,50,100,200,500,1e3],mM=25,gM=n=>Ss.find(e=>e>=1&&n/e<=mM*1.2)??Ss[Ss.length-1],fc=class{constructor(e,t){this.from=e;this.to=t;this.time=e,this.rate=gM(t-e)}from;to;playing=!1;rate;time;seek(e){this.time=Math.min(this.to,Math.max(this.from,e))}toggle(){this.playing=!this.playing,this.playing&&this.time>=this.to&&(this.time=this.from)}advance(e){return this.playing?(this.seek(this.time+this.rate*Math.min(e,.25)),this.time>=this.to&&(this.playing=!1),!0):!1}};var Aa={play:"M4 2.5v11l9-5.5z",pause:"M4 3h3v10H4zM9 3h3v10H9z",before:"M3 3h2v10H3zM13 3v10L6 8z",next:"M11 3h2v10h-2zM3 3v10l7-5z"},l0=n=>je("svg",{width:14,height:14,viewBox:"0 0 16 16","aria-hidden":"true"},je("path",{d:n,fill:"currentColor"})),Nd=(n,e,t,i)=>P("button",{type:"button","aria-label":e,title:`${e} (${t})`,"aria-keyshortcuts":t,onclick:i},l0(n)),Dd=4e3,pc=class{constructor(e,t,i){this.playback=e;this.play=Nd(Aa.play,"Play","Space",()=>i.toggle()),this.slider.setAttribute("aria-label","Simulated time"),this.slider.addEventListener("input",()=>i.seek(this.timeOf(this.slider.valueAsNumber))),this.followBox.addEventListener("change",()=>i.follow(this.followBox.checked));let s=this.rates=P("select",{title:"Simulated seconds a second"},...Ss.map(a=>P("option",{value:a},`${a}\xD7`)));s.value=String(e.rate),s.addEventListener("change",()=>e.rate=Number(s.value));let r=P("select",{class:"view-jump","aria-label":"Jump to an event"},P("option",{value:""},"Jump to\u2026"),...t.map((a,l)=>P("option",{value:l},`${Ta(a.time_s,e.to)}  ${a.what.slice(0,80)}`)));r.addEventListener("change",()=>{let a=t[Number(r.value)];r.value&&a&&i.seek(a.time_s),r.value=""});let o=P("div",{class:"view-track"},this.slider,this.ticks(t));this.root=P("div",{class:"view-player"},this.play,Nd(Aa.before,"Event before","Shift+E",()=>i.event(-1)),Nd(Aa.next,"Next event","E",()=>i.event(1)),o,this.reading,P("label",{class:"view-field"},"Speed",s),r,P("label",{class:"view-field",title:"Camera goes with the head (F)"},this.followBox,"Follow head"))}playback;root;play;rates;slider=P("input",{type:"range",min:0,max:Dd,step:"any",class:"view-time"});reading=P("output",{class:"view-reading"});followBox=P("input",{type:"checkbox"});timeOf(e){let{from:t,to:i}=this.playback;return t+(i-t)*e/Dd}ticks(e){let{from:t,to:i}=this.playback;return P("div",{class:"view-ticks","aria-hidden":"true"},...e.map(s=>{let r=P("i");return r.style.left=`${100*(s.time_s-t)/Math.max(1e-9,i-t)}%`,r}))}update(){let{time:e,from:t,to:i,playing:s}=this.playback;this.slider.valueAsNumber=Dd*(e-t)/Math.max(1e-9,i-t);let r=Ta(e,i);this.reading.textContent!==r&&(this.reading.textContent=r,this.slider.setAttribute("aria-valuetext",r));let o=s?"Pause":"Play";this.play.getAttribute("aria-label")!==o&&(this.play.replaceChildren(l0(s?Aa.pause:Aa.play)),this.play.setAttribute("aria-label",o))}following(e){this.followBox.checked=e}rated(){this.rates.value=String(this.playback.rate)}};var mc=class{constructor(e,t,i,s=[]){this.store=t;this.narrator=i;this.model=oc(e),this.beside=new ac(s,this.model),this.colouring=new cc(this.model);let r=e.states?.time_s??[];this.playback=new fc(r[0]??0,r[r.length-1]??0),this.events=(e.summary.events??[]).filter(o=>Number.isFinite(o.time_s)),this.inspector=new uc(o=>this.seek(o),()=>this.leave()),this.player=new pc(this.playback,this.events,this),this.tools=new nc(this.model.bends,this.colouring.choices,this)}store;narrator;model;beside;playback;legend=new dc;inspector;player;tools;now=null;world=null;cameras=null;forces=null;colouring;events;stale=!0;choice=null;hovered=-1;request=0;draws(e,t){this.world=e,this.cameras=t,t.onChange=(i,s)=>{this.tools.atBend(i),this.player.following(s)},e.stage.onFrame=i=>this.tick(i)}arrived(e,t){t==="position"&&(this.now=new To(e,this.model),e0(e,this.model),this.model.path||this.preset(0,!0)),t===this.colouring.quantity.field&&this.colour(t),this.refresh()}grown(e){let{playback:t}=this,i=t.time>=t.to-1e-9;t.to=e.to,i&&!t.playing&&t.seek(e.to),this.colouring.grown();for(let s of e.fields.keys())this.arrived(e,s)}besideArrived(e,t){this.beside.arrived(e,t),this.refresh()}refresh(){this.stale=!0,this.world?this.world.stage.invalidate():this.request||=requestAnimationFrame(()=>this.unseen())}unseen(){this.request=0,this.tick(1/60)&&this.refresh()}tick(e){let{playback:t,now:i,world:s}=this;return t.advance(e)&&(this.stale=!0,this.store.set("time",t.time,this)),i&&this.stale&&i.show(t.time,this.colouring.quantity.field)&&this.cameras?.goWithHead(i),this.stale&&this.beside.show(t.time,this.colouring.quantity.field),s?.update(this.stale?i:null),i&&this.stale&&this.tell(i),this.stale=!1,this.player.update(),s&&(s.updateLabels(),this.legend.sizes(s.factor,s.ground.spacing,this.store.get("units"))),t.playing}tell(e){let t=this.store.get("units"),i=this.world?.labels,s=e.largestTension;if(i?.set("head",{text:"Head",point:e.centre(this.model.head),weight:90,kind:"head"}),s&&i){let r=`Largest ${Qe(s.value,"N",t,3)}`;i.set("largest",{text:r,point:e.centre(s.segment),weight:95,kind:"largest"})}this.narrator.tell(()=>rc(e,this.model,t),this.playback.playing),this.inspector.at(e.time)}showAt(e){this.playback.seek(e),this.refresh()}seek(e){this.playback.seek(e),this.store.set("time",this.playback.time,this),this.refresh()}toggle(){this.playback.toggle(),this.refresh()}step(e){let t=this.now?.frames;if(!t)return;this.playback.playing=!1;let{frame:i,part:s}=t.between(this.playback.time),r=e<0&&s>1e-6?i+1:i;this.seek(t.time[Math.min(t.count-1,Math.max(0,r+e))])}end(e){this.seek(e?this.playback.to:this.playback.from)}faster(e){let t=Ss.indexOf(this.playback.rate)+e;this.playback.rate=Ss[Math.min(Ss.length-1,Math.max(0,t))],this.player.rated()}event(e){let{time:t}=this.playback,i=this.events.map(r=>r.time_s).sort((r,o)=>r-o),s=e>0?i.find(r=>r>t+1e-6):i.filter(r=>r<t-1e-6).pop();s!==void 0&&this.seek(s)}zoom(e){this.world?.stage.zoom(e)}orbit(e,t){this.world?.stage.orbit(e,t)}factor(e){this.world?.exaggerate(e)}preset(e,t=!1){this.cameras?.preset(e,this.place,t)}bend(e){this.cameras?.bend(e)}nextBend(e){this.cameras?.nextBend(e)}follow(e){this.cameras?.follow(e)}toPlace(e=this.place){e!==null&&this.model.path&&this.cameras?.lookAt(this.model.path.at(e))}colour(e){let{colouring:t}=this;t.choose(e);let i=t.scale(this.now?.frames);this.tools.coloured(e),this.world?.scale(i),this.legend.scale(t.quantity,i,this.store.get("units")),this.choice&&"place"in this.choice&&this.inspect(this.choice),this.refresh()}nextColour(){this.colour(this.colouring.next.field)}get place(){return this.store.get("place")??(this.choice&&"place"in this.choice?this.choice.place:null)}inspect(e){this.choice=e;let{model:t,now:i}=this,s=this.store.get("units"),r=e&&"roller"in e?e.roller:null;this.store.set("roller",r,this);let o=e&&"place"in e&&i,a=r!==null?Yg(t,r,this.forces,s):o?Zg(t,e.place,i,this.colouring.quantity,s):null;this.inspector.show(a,this.store.get("theme")),this.world?.rollers?.mark(r??-1,-1),this.mark()}inspectAgain(){this.choice&&this.inspect(this.choice)}leave(){this.inspect(null)}hover(e){this.hovered=e,this.mark()}mark(){let{model:e,world:t,place:i,hovered:s}=this,r=e.run.geometry?.rollers[s]?.name.slice(0,60),o=i===null?"":Di(i,this.store.get("units")),a=r?t?.rollers?.centre(s):i===null?void 0:e.path?.at(i),l=[r,o].filter(Boolean).join(" \xB7 ");t?.labels.set("place",a?{text:l,point:a,weight:200,kind:"place"}:null),t?.stage.invalidate()}redress(){let e=this.store.get("units");this.tools.units(e),this.world&&(a0(this.world.labels,this.model,e),this.world.unit=1/kt("m",e,1).factor,this.world.paint(this.store.get("theme"))),this.colour(this.colouring.quantity.field),this.inspectAgain(),this.mark()}dispose(){cancelAnimationFrame(this.request),this.narrator.dispose(),this.inspector.dispose(),this.world?.dispose()}};var ar={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},lr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},P0=0,df=1,I0=2;var nl=1,L0=2,$o=3,Ji=0,si=1,ui=2,ds=0,kr=1,ff=2,pf=3,mf=4,N0=5;var er=100,D0=101,F0=102,U0=103,O0=104,k0=200,B0=201,V0=202,z0=203,Bc=204,Vc=205,G0=206,H0=207,W0=208,X0=209,q0=210,$0=211,Y0=212,Z0=213,K0=214,zc=0,Gc=1,Hc=2,Br=3,Wc=4,Xc=5,qc=6,$c=7,gf=0,J0=1,j0=2,Qi=0,_f=1,xf=2,yf=3,vf=4,bf=5,Mf=6,Sf=7;var wf=300,cr=301,Wr=302,xu=303,yu=304,il=306,Yc=1e3,cs=1001,Zc=1002,yn=1003,Q0=1004;var sl=1005;var Tn=1006,vu=1007;var ur=1008;var Ci=1009,Tf=1010,Ef=1011,Yo=1012,bu=1013,es=1014,Ri=1015,fs=1016,Mu=1017,Su=1018,Zo=1020,Af=35902,Cf=35899,Rf=1021,Pf=1022,ri=1023,us=1026,hr=1027,If=1028,wu=1029,dr=1030,Tu=1031;var Eu=1033,rl=33776,ol=33777,al=33778,ll=33779,Au=35840,Cu=35841,Ru=35842,Pu=35843,Iu=36196,Lu=37492,Nu=37496,Du=37488,Fu=37489,cl=37490,Uu=37491,Ou=37808,ku=37809,Bu=37810,Vu=37811,zu=37812,Gu=37813,Hu=37814,Wu=37815,Xu=37816,qu=37817,$u=37818,Yu=37819,Zu=37820,Ku=37821,Ju=36492,ju=36494,Qu=36495,eh=36283,th=36284,ul=36285,nh=36286;var Fa=2300,Kc=2301,kc=2302,sf=2303,rf=2400,of=2401,af=2402;var e_=3200;var Lf=0,t_=1,Ls="",wi="srgb",Ua="srgb-linear",Oa="linear",Nt="srgb";var Ur=7680;var lf=519,n_=512,i_=513,s_=514,ih=515,r_=516,o_=517,sh=518,a_=519,cf=35044;var Nf="300 es",Zi=2e3,ka=2001;function _M(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function xM(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Ba(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function l_(){let n=Ba("canvas");return n.style.display="block",n}var c0={},Vo=null;function Df(...n){let e="THREE."+n.shift();Vo?Vo("log",e,...n):console.log(e,...n)}function c_(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function $e(...n){n=c_(n);let e="THREE."+n.shift();if(Vo)Vo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function Ke(...n){n=c_(n);let e="THREE."+n.shift();if(Vo)Vo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Or(...n){let e=n.join(" ");e in c0||(c0[e]=!0,$e(...n))}function u_(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var h_={[zc]:Gc,[Hc]:qc,[Wc]:$c,[Br]:Xc,[Gc]:zc,[qc]:Hc,[$c]:Wc,[Xc]:Br},ji=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Gn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],u0=1234567,Na=Math.PI/180,zo=180/Math.PI;function Ko(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Gn[n&255]+Gn[n>>8&255]+Gn[n>>16&255]+Gn[n>>24&255]+"-"+Gn[e&255]+Gn[e>>8&255]+"-"+Gn[e>>16&15|64]+Gn[e>>24&255]+"-"+Gn[t&63|128]+Gn[t>>8&255]+"-"+Gn[t>>16&255]+Gn[t>>24&255]+Gn[i&255]+Gn[i>>8&255]+Gn[i>>16&255]+Gn[i>>24&255]).toLowerCase()}function ut(n,e,t){return Math.max(e,Math.min(t,n))}function Ff(n,e){return(n%e+e)%e}function yM(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function vM(n,e,t){return n!==e?(t-n)/(e-n):0}function Da(n,e,t){return(1-t)*n+t*e}function bM(n,e,t,i){return Da(n,e,1-Math.exp(-t*i))}function MM(n,e=1){return e-Math.abs(Ff(n,e*2)-e)}function SM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function wM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function TM(n,e){return n+Math.floor(Math.random()*(e-n+1))}function EM(n,e){return n+Math.random()*(e-n)}function AM(n){return n*(.5-Math.random())}function CM(n){n!==void 0&&(u0=n);let e=u0+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function RM(n){return n*Na}function PM(n){return n*zo}function IM(n){return(n&n-1)===0&&n!==0}function LM(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function NM(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function DM(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),d=r((e-i)/2),h=o((e-i)/2),f=r((i-e)/2),p=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*d,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*d,a*c);break;case"ZXZ":n.set(l*d,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*u,a*c);break;default:$e("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function ko(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("THREE.MathUtils: Invalid component type.")}}function ii(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("THREE.MathUtils: Invalid component type.")}}var Uf={DEG2RAD:Na,RAD2DEG:zo,generateUUID:Ko,clamp:ut,euclideanModulo:Ff,mapLinear:yM,inverseLerp:vM,lerp:Da,damp:bM,pingpong:MM,smoothstep:SM,smootherstep:wM,randInt:TM,randFloat:EM,randFloatSpread:AM,seededRandom:CM,degToRad:RM,radToDeg:PM,isPowerOfTwo:IM,ceilPowerOfTwo:LM,floorPowerOfTwo:NM,setQuaternionFromProperEuler:DM,normalize:ii,denormalize:ko},Je=class n{static{n.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ut(this.x,e.x,t.x),this.y=ut(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ut(this.x,e,t),this.y=ut(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ut(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ut(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Xn=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],d=i[s+3],h=r[o+0],f=r[o+1],p=r[o+2],v=r[o+3];if(d!==v||l!==h||c!==f||u!==p){let g=l*h+c*f+u*p+d*v;g<0&&(h=-h,f=-f,p=-p,v=-v,g=-g);let m=1-a;if(g<.9995){let S=Math.acos(g),A=Math.sin(S);m=Math.sin(m*S)/A,a=Math.sin(a*S)/A,l=l*m+h*a,c=c*m+f*a,u=u*m+p*a,d=d*m+v*a}else{l=l*m+h*a,c=c*m+f*a,u=u*m+p*a,d=d*m+v*a;let S=1/Math.sqrt(l*l+c*c+u*u+d*d);l*=S,c*=S,u*=S,d*=S}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=d}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],d=r[o],h=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+u*d+l*f-c*h,e[t+1]=l*p+u*h+c*d-a*f,e[t+2]=c*p+u*f+a*h-l*d,e[t+3]=u*p-a*d-l*h-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),d=a(r/2),h=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=h*u*d+c*f*p,this._y=c*f*d-h*u*p,this._z=c*u*p+h*f*d,this._w=c*u*d-h*f*p;break;case"YXZ":this._x=h*u*d+c*f*p,this._y=c*f*d-h*u*p,this._z=c*u*p-h*f*d,this._w=c*u*d+h*f*p;break;case"ZXY":this._x=h*u*d-c*f*p,this._y=c*f*d+h*u*p,this._z=c*u*p+h*f*d,this._w=c*u*d-h*f*p;break;case"ZYX":this._x=h*u*d-c*f*p,this._y=c*f*d+h*u*p,this._z=c*u*p-h*f*d,this._w=c*u*d+h*f*p;break;case"YZX":this._x=h*u*d+c*f*p,this._y=c*f*d+h*u*p,this._z=c*u*p-h*f*d,this._w=c*u*d-h*f*p;break;case"XZY":this._x=h*u*d-c*f*p,this._y=c*f*d-h*u*p,this._z=c*u*p+h*f*d,this._w=c*u*d+h*f*p;break;default:$e("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],d=t[10],h=i+a+d;if(h>0){let f=.5/Math.sqrt(h+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>d){let f=2*Math.sqrt(1+i-a-d);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>d){let f=2*Math.sqrt(1+a-i-d);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+d-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ut(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},z=class n{static{n.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(h0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(h0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),d=2*(r*i-o*t);return this.x=t+l*c+o*d-a*u,this.y=i+l*u+a*c-r*d,this.z=s+l*d+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ut(this.x,e.x,t.x),this.y=ut(this.y,e.y,t.y),this.z=ut(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ut(this.x,e,t),this.y=ut(this.y,e,t),this.z=ut(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ut(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Fd.copy(this).projectOnVector(e),this.sub(Fd)}reflect(e){return this.sub(Fd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ut(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Fd=new z,h0=new Xn,it=class n{static{n.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],d=i[7],h=i[2],f=i[5],p=i[8],v=s[0],g=s[3],m=s[6],S=s[1],A=s[4],b=s[7],C=s[2],T=s[5],N=s[8];return r[0]=o*v+a*S+l*C,r[3]=o*g+a*A+l*T,r[6]=o*m+a*b+l*N,r[1]=c*v+u*S+d*C,r[4]=c*g+u*A+d*T,r[7]=c*m+u*b+d*N,r[2]=h*v+f*S+p*C,r[5]=h*g+f*A+p*T,r[8]=h*m+f*b+p*N,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],d=u*o-a*c,h=a*l-u*r,f=c*r-o*l,p=t*d+i*h+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/p;return e[0]=d*v,e[1]=(s*c-u*i)*v,e[2]=(a*i-s*o)*v,e[3]=h*v,e[4]=(u*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=f*v,e[7]=(i*l-c*t)*v,e[8]=(o*t-i*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Or("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Ud.makeScale(e,t)),this}rotate(e){return Or("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Ud.makeRotation(-e)),this}translate(e,t){return Or("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Ud.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Ud=new it,d0=new it().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),f0=new it().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function FM(){let n={enabled:!0,workingColorSpace:Ua,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Nt&&(s.r=Rs(s.r),s.g=Rs(s.g),s.b=Rs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Nt&&(s.r=Bo(s.r),s.g=Bo(s.g),s.b=Bo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ls?Oa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return Or("ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),n.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return Or("ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),n.colorSpaceToWorking(s,r)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ua]:{primaries:e,whitePoint:i,transfer:Oa,toXYZ:d0,fromXYZ:f0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:wi},outputColorSpaceConfig:{drawingBufferColorSpace:wi}},[wi]:{primaries:e,whitePoint:i,transfer:Nt,toXYZ:d0,fromXYZ:f0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:wi}}}),n}var _t=FM();function Rs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Bo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Eo,Jc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Eo===void 0&&(Eo=Ba("canvas")),Eo.width=e.width,Eo.height=e.height;let s=Eo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Eo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ba("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Rs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Rs(t[i]/255)*255):t[i]=Rs(t[i]);return{data:t,width:e.width,height:e.height}}else return $e("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},UM=0,Go=class{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:UM++}),this.uuid=Ko(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Od(s[o].image)):r.push(Od(s[o]))}else r=Od(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Od(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Jc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:($e("Texture: Unable to serialize Texture."),{})}var OM=0,kd=new z,ci=class n extends ji{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=cs,s=cs,r=Tn,o=ur,a=ri,l=Ci,c=n.DEFAULT_ANISOTROPY,u=Ls){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:OM++}),this.uuid=Ko(),this.name="",this.source=new Go(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Je(0,0),this.repeat=new Je(1,1),this.center=new Je(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new it,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.normalized=!1}get width(){return this.source.getSize(kd).x}get height(){return this.source.getSize(kd).y}get depth(){return this.source.getSize(kd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){$e(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==wf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Yc:e.x=e.x-Math.floor(e.x);break;case cs:e.x=e.x<0?0:1;break;case Zc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Yc:e.y=e.y-Math.floor(e.y);break;case cs:e.y=e.y<0?0:1;break;case Zc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ci.DEFAULT_IMAGE=null;ci.DEFAULT_MAPPING=wf;ci.DEFAULT_ANISOTROPY=1;var Qt=class n{static{n.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],d=l[8],h=l[1],f=l[5],p=l[9],v=l[2],g=l[6],m=l[10];if(Math.abs(u-h)<.01&&Math.abs(d-v)<.01&&Math.abs(p-g)<.01){if(Math.abs(u+h)<.1&&Math.abs(d+v)<.1&&Math.abs(p+g)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(c+1)/2,b=(f+1)/2,C=(m+1)/2,T=(u+h)/4,N=(d+v)/4,y=(p+g)/4;return A>b&&A>C?A<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(A),s=T/i,r=N/i):b>C?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=T/s,r=y/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=N/r,s=y/r),this.set(i,s,r,t),this}let S=Math.sqrt((g-p)*(g-p)+(d-v)*(d-v)+(h-u)*(h-u));return Math.abs(S)<.001&&(S=1),this.x=(g-p)/S,this.y=(d-v)/S,this.z=(h-u)/S,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ut(this.x,e.x,t.x),this.y=ut(this.y,e.y,t.y),this.z=ut(this.z,e.z,t.z),this.w=ut(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ut(this.x,e,t),this.y=ut(this.y,e,t),this.z=ut(this.z,e,t),this.w=ut(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ut(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},jc=class extends ji{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Tn,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Qt(0,0,e,t),this.scissorTest=!1,this.viewport=new Qt(0,0,e,t),this.textures=[];let s={width:e,height:t,depth:i.depth},r=new ci(s),o=i.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Tn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Go(s)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ti=class extends jc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Va=class extends ci{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=yn,this.minFilter=yn,this.wrapR=cs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Qc=class extends ci{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=yn,this.minFilter=yn,this.wrapR=cs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Gt=class n{static{n.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,d,h,f,p,v,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,d,h,f,p,v,g)}set(e,t,i,s,r,o,a,l,c,u,d,h,f,p,v,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=d,m[14]=h,m[3]=f,m[7]=p,m[11]=v,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Ao.setFromMatrixColumn(e,0).length(),r=1/Ao.setFromMatrixColumn(e,1).length(),o=1/Ao.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let h=o*u,f=o*d,p=a*u,v=a*d;t[0]=l*u,t[4]=-l*d,t[8]=c,t[1]=f+p*c,t[5]=h-v*c,t[9]=-a*l,t[2]=v-h*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,f=l*d,p=c*u,v=c*d;t[0]=h+v*a,t[4]=p*a-f,t[8]=o*c,t[1]=o*d,t[5]=o*u,t[9]=-a,t[2]=f*a-p,t[6]=v+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,f=l*d,p=c*u,v=c*d;t[0]=h-v*a,t[4]=-o*d,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*u,t[9]=v-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,f=o*d,p=a*u,v=a*d;t[0]=l*u,t[4]=p*c-f,t[8]=h*c+v,t[1]=l*d,t[5]=v*c+h,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,f=o*c,p=a*l,v=a*c;t[0]=l*u,t[4]=v-h*d,t[8]=p*d+f,t[1]=d,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*d+p,t[10]=h-v*d}else if(e.order==="XZY"){let h=o*l,f=o*c,p=a*l,v=a*c;t[0]=l*u,t[4]=-d,t[8]=c*u,t[1]=h*d+v,t[5]=o*u,t[9]=f*d-p,t[2]=p*d-f,t[6]=a*u,t[10]=v*d+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(kM,e,BM)}lookAt(e,t,i){let s=this.elements;return Mi.subVectors(e,t),Mi.lengthSq()===0&&(Mi.z=1),Mi.normalize(),$s.crossVectors(i,Mi),$s.lengthSq()===0&&(Math.abs(i.z)===1?Mi.x+=1e-4:Mi.z+=1e-4,Mi.normalize(),$s.crossVectors(i,Mi)),$s.normalize(),gc.crossVectors(Mi,$s),s[0]=$s.x,s[4]=gc.x,s[8]=Mi.x,s[1]=$s.y,s[5]=gc.y,s[9]=Mi.y,s[2]=$s.z,s[6]=gc.z,s[10]=Mi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],d=i[5],h=i[9],f=i[13],p=i[2],v=i[6],g=i[10],m=i[14],S=i[3],A=i[7],b=i[11],C=i[15],T=s[0],N=s[4],y=s[8],E=s[12],F=s[1],I=s[5],U=s[9],k=s[13],X=s[2],O=s[6],$=s[10],H=s[14],ie=s[3],oe=s[7],le=s[11],de=s[15];return r[0]=o*T+a*F+l*X+c*ie,r[4]=o*N+a*I+l*O+c*oe,r[8]=o*y+a*U+l*$+c*le,r[12]=o*E+a*k+l*H+c*de,r[1]=u*T+d*F+h*X+f*ie,r[5]=u*N+d*I+h*O+f*oe,r[9]=u*y+d*U+h*$+f*le,r[13]=u*E+d*k+h*H+f*de,r[2]=p*T+v*F+g*X+m*ie,r[6]=p*N+v*I+g*O+m*oe,r[10]=p*y+v*U+g*$+m*le,r[14]=p*E+v*k+g*H+m*de,r[3]=S*T+A*F+b*X+C*ie,r[7]=S*N+A*I+b*O+C*oe,r[11]=S*y+A*U+b*$+C*le,r[15]=S*E+A*k+b*H+C*de,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],d=e[6],h=e[10],f=e[14],p=e[3],v=e[7],g=e[11],m=e[15],S=l*f-c*h,A=a*f-c*d,b=a*h-l*d,C=o*f-c*u,T=o*h-l*u,N=o*d-a*u;return t*(v*S-g*A+m*b)-i*(p*S-g*C+m*T)+s*(p*A-v*C+m*N)-r*(p*b-v*T+g*N)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],d=e[9],h=e[10],f=e[11],p=e[12],v=e[13],g=e[14],m=e[15],S=t*a-i*o,A=t*l-s*o,b=t*c-r*o,C=i*l-s*a,T=i*c-r*a,N=s*c-r*l,y=u*v-d*p,E=u*g-h*p,F=u*m-f*p,I=d*g-h*v,U=d*m-f*v,k=h*m-f*g,X=S*k-A*U+b*I+C*F-T*E+N*y;if(X===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let O=1/X;return e[0]=(a*k-l*U+c*I)*O,e[1]=(s*U-i*k-r*I)*O,e[2]=(v*N-g*T+m*C)*O,e[3]=(h*T-d*N-f*C)*O,e[4]=(l*F-o*k-c*E)*O,e[5]=(t*k-s*F+r*E)*O,e[6]=(g*b-p*N-m*A)*O,e[7]=(u*N-h*b+f*A)*O,e[8]=(o*U-a*F+c*y)*O,e[9]=(i*F-t*U-r*y)*O,e[10]=(p*T-v*b+m*S)*O,e[11]=(d*b-u*T-f*S)*O,e[12]=(a*E-o*I-l*y)*O,e[13]=(t*I-i*E+s*y)*O,e[14]=(v*A-p*C-g*S)*O,e[15]=(u*C-d*A+h*S)*O,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,d=a+a,h=r*c,f=r*u,p=r*d,v=o*u,g=o*d,m=a*d,S=l*c,A=l*u,b=l*d,C=i.x,T=i.y,N=i.z;return s[0]=(1-(v+m))*C,s[1]=(f+b)*C,s[2]=(p-A)*C,s[3]=0,s[4]=(f-b)*T,s[5]=(1-(h+m))*T,s[6]=(g+S)*T,s[7]=0,s[8]=(p+A)*N,s[9]=(g-S)*N,s[10]=(1-(h+v))*N,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Ao.set(s[0],s[1],s[2]).length(),a=Ao.set(s[4],s[5],s[6]).length(),l=Ao.set(s[8],s[9],s[10]).length();r<0&&(o=-o),qi.copy(this);let c=1/o,u=1/a,d=1/l;return qi.elements[0]*=c,qi.elements[1]*=c,qi.elements[2]*=c,qi.elements[4]*=u,qi.elements[5]*=u,qi.elements[6]*=u,qi.elements[8]*=d,qi.elements[9]*=d,qi.elements[10]*=d,t.setFromRotationMatrix(qi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Zi,l=!1){let c=this.elements,u=2*r/(t-e),d=2*r/(i-s),h=(t+e)/(t-e),f=(i+s)/(i-s),p,v;if(l)p=r/(o-r),v=o*r/(o-r);else if(a===Zi)p=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===ka)p=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Zi,l=!1){let c=this.elements,u=2/(t-e),d=2/(i-s),h=-(t+e)/(t-e),f=-(i+s)/(i-s),p,v;if(l)p=1/(o-r),v=o/(o-r);else if(a===Zi)p=-2/(o-r),v=-(o+r)/(o-r);else if(a===ka)p=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Ao=new z,qi=new Gt,kM=new z(0,0,0),BM=new z(1,1,1),$s=new z,gc=new z,Mi=new z,p0=new Gt,m0=new Xn,tr=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],d=s[2],h=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(ut(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ut(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(ut(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ut(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(h,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ut(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ut(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:$e("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return p0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(p0,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return m0.setFromEuler(this),this.setFromQuaternion(m0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};tr.DEFAULT_ORDER="XYZ";var za=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},VM=0,g0=new z,Co=new Xn,ws=new Gt,_c=new z,Ca=new z,zM=new z,GM=new Xn,_0=new z(1,0,0),x0=new z(0,1,0),y0=new z(0,0,1),v0={type:"added"},HM={type:"removed"},Ro={type:"childadded",child:null},Bd={type:"childremoved",child:null},Ei=class n extends ji{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:VM++}),this.uuid=Ko(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new z,t=new tr,i=new Xn,s=new z(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Gt},normalMatrix:{value:new it}}),this.matrix=new Gt,this.matrixWorld=new Gt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new za,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Co.setFromAxisAngle(e,t),this.quaternion.multiply(Co),this}rotateOnWorldAxis(e,t){return Co.setFromAxisAngle(e,t),this.quaternion.premultiply(Co),this}rotateX(e){return this.rotateOnAxis(_0,e)}rotateY(e){return this.rotateOnAxis(x0,e)}rotateZ(e){return this.rotateOnAxis(y0,e)}translateOnAxis(e,t){return g0.copy(e).applyQuaternion(this.quaternion),this.position.add(g0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(_0,e)}translateY(e){return this.translateOnAxis(x0,e)}translateZ(e){return this.translateOnAxis(y0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ws.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?_c.copy(e):_c.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Ca.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ws.lookAt(Ca,_c,this.up):ws.lookAt(_c,Ca,this.up),this.quaternion.setFromRotationMatrix(ws),s&&(ws.extractRotation(s.matrixWorld),Co.setFromRotationMatrix(ws),this.quaternion.premultiply(Co.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Ke("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(v0),Ro.child=e,this.dispatchEvent(Ro),Ro.child=null):Ke("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(HM),Bd.child=e,this.dispatchEvent(Bd),Bd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ws.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ws.multiply(e.parent.matrixWorld)),e.applyMatrix4(ws),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(v0),Ro.child=e,this.dispatchEvent(Ro),Ro.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ca,e,zM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ca,GM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),this.static!==!1&&(s.static=this.static),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let d=l[c];r(e.shapes,d)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),d=o(e.shapes),h=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),d.length>0&&(i.shapes=d),h.length>0&&(i.skeletons=h),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}};Ei.DEFAULT_UP=new z(0,1,0);Ei.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ei.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ki=class extends Ei{constructor(){super(),this.isGroup=!0,this.type="Group"}},WM={type:"move"},Ho=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ki,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ki,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ki,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new z,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let g=t.getJointPose(v,i),m=this._getHandJoint(c,v);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.rotation,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],h=u.position.distanceTo(d.position),f=.02,p=.005;c.inputState.pinching&&h>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(WM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Ki;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},d_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ys={h:0,s:0,l:0},xc={h:0,s:0,l:0};function Vd(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var xt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=wi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,_t.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=_t.workingColorSpace){return this.r=e,this.g=t,this.b=i,_t.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=_t.workingColorSpace){if(e=Ff(e,1),t=ut(t,0,1),i=ut(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Vd(o,r,e+1/3),this.g=Vd(o,r,e),this.b=Vd(o,r,e-1/3)}return _t.colorSpaceToWorking(this,s),this}setStyle(e,t=wi){function i(r){r!==void 0&&parseFloat(r)<1&&$e("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:$e("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);$e("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=wi){let i=d_[e.toLowerCase()];return i!==void 0?this.setHex(i,t):$e("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Rs(e.r),this.g=Rs(e.g),this.b=Rs(e.b),this}copyLinearToSRGB(e){return this.r=Bo(e.r),this.g=Bo(e.g),this.b=Bo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=wi){return _t.workingToColorSpace(Hn.copy(this),e),Math.round(ut(Hn.r*255,0,255))*65536+Math.round(ut(Hn.g*255,0,255))*256+Math.round(ut(Hn.b*255,0,255))}getHexString(e=wi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=_t.workingColorSpace){_t.workingToColorSpace(Hn.copy(this),t);let i=Hn.r,s=Hn.g,r=Hn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=u<=.5?d/(o+a):d/(2-o-a),o){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=_t.workingColorSpace){return _t.workingToColorSpace(Hn.copy(this),t),e.r=Hn.r,e.g=Hn.g,e.b=Hn.b,e}getStyle(e=wi){_t.workingToColorSpace(Hn.copy(this),e);let t=Hn.r,i=Hn.g,s=Hn.b;return e!==wi?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Ys),this.setHSL(Ys.h+e,Ys.s+t,Ys.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Ys),e.getHSL(xc);let i=Da(Ys.h,xc.h,t),s=Da(Ys.s,xc.s,t),r=Da(Ys.l,xc.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Hn=new xt;xt.NAMES=d_;var Ga=class extends Ei{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new tr,this.environmentIntensity=1,this.environmentRotation=new tr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}},$i=new z,Ts=new z,zd=new z,Es=new z,Po=new z,Io=new z,b0=new z,Gd=new z,Hd=new z,Wd=new z,Xd=new Qt,qd=new Qt,$d=new Qt,Qs=class n{constructor(e=new z,t=new z,i=new z){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),$i.subVectors(e,t),s.cross($i);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){$i.subVectors(s,t),Ts.subVectors(i,t),zd.subVectors(e,t);let o=$i.dot($i),a=$i.dot(Ts),l=$i.dot(zd),c=Ts.dot(Ts),u=Ts.dot(zd),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let h=1/d,f=(c*l-a*u)*h,p=(o*u-a*l)*h;return r.set(1-f-p,p,f)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Es)===null?!1:Es.x>=0&&Es.y>=0&&Es.x+Es.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Es)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Es.x),l.addScaledVector(o,Es.y),l.addScaledVector(a,Es.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return Xd.setScalar(0),qd.setScalar(0),$d.setScalar(0),Xd.fromBufferAttribute(e,t),qd.fromBufferAttribute(e,i),$d.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Xd,r.x),o.addScaledVector(qd,r.y),o.addScaledVector($d,r.z),o}static isFrontFacing(e,t,i,s){return $i.subVectors(i,t),Ts.subVectors(e,t),$i.cross(Ts).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return $i.subVectors(this.c,this.b),Ts.subVectors(this.a,this.b),$i.cross(Ts).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Po.subVectors(s,i),Io.subVectors(r,i),Gd.subVectors(e,i);let l=Po.dot(Gd),c=Io.dot(Gd);if(l<=0&&c<=0)return t.copy(i);Hd.subVectors(e,s);let u=Po.dot(Hd),d=Io.dot(Hd);if(u>=0&&d<=u)return t.copy(s);let h=l*d-u*c;if(h<=0&&l>=0&&u<=0)return o=l/(l-u),t.copy(i).addScaledVector(Po,o);Wd.subVectors(e,r);let f=Po.dot(Wd),p=Io.dot(Wd);if(p>=0&&f<=p)return t.copy(r);let v=f*c-l*p;if(v<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(Io,a);let g=u*p-f*d;if(g<=0&&d-u>=0&&f-p>=0)return b0.subVectors(r,s),a=(d-u)/(d-u+(f-p)),t.copy(s).addScaledVector(b0,a);let m=1/(g+v+h);return o=v*m,a=h*m,t.copy(i).addScaledVector(Po,o).addScaledVector(Io,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},nr=class{constructor(e=new z(1/0,1/0,1/0),t=new z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Yi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Yi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Yi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Yi):Yi.fromBufferAttribute(r,o),Yi.applyMatrix4(e.matrixWorld),this.expandByPoint(Yi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),yc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),yc.copy(i.boundingBox)),yc.applyMatrix4(e.matrixWorld),this.union(yc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Yi),Yi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ra),vc.subVectors(this.max,Ra),Lo.subVectors(e.a,Ra),No.subVectors(e.b,Ra),Do.subVectors(e.c,Ra),Zs.subVectors(No,Lo),Ks.subVectors(Do,No),Lr.subVectors(Lo,Do);let t=[0,-Zs.z,Zs.y,0,-Ks.z,Ks.y,0,-Lr.z,Lr.y,Zs.z,0,-Zs.x,Ks.z,0,-Ks.x,Lr.z,0,-Lr.x,-Zs.y,Zs.x,0,-Ks.y,Ks.x,0,-Lr.y,Lr.x,0];return!Yd(t,Lo,No,Do,vc)||(t=[1,0,0,0,1,0,0,0,1],!Yd(t,Lo,No,Do,vc))?!1:(bc.crossVectors(Zs,Ks),t=[bc.x,bc.y,bc.z],Yd(t,Lo,No,Do,vc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Yi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Yi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(As[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),As[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),As[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),As[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),As[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),As[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),As[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),As[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(As),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},As=[new z,new z,new z,new z,new z,new z,new z,new z],Yi=new z,yc=new nr,Lo=new z,No=new z,Do=new z,Zs=new z,Ks=new z,Lr=new z,Ra=new z,vc=new z,bc=new z,Nr=new z;function Yd(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Nr.fromArray(n,r);let a=s.x*Math.abs(Nr.x)+s.y*Math.abs(Nr.y)+s.z*Math.abs(Nr.z),l=e.dot(Nr),c=t.dot(Nr),u=i.dot(Nr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var xn=new z,Mc=new Je,XM=0,li=class extends ji{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:XM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=cf,this.updateRanges=[],this.gpuType=Ri,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Mc.fromBufferAttribute(this,t),Mc.applyMatrix3(e),this.setXY(t,Mc.x,Mc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix3(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix4(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyNormalMatrix(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.transformDirection(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=ko(i,this.array)),i}setComponent(e,t,i){return this.normalized&&(i=ii(i,this.array)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=ko(t,this.array)),t}setX(e,t){return this.normalized&&(t=ii(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=ko(t,this.array)),t}setY(e,t){return this.normalized&&(t=ii(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=ko(t,this.array)),t}setZ(e,t){return this.normalized&&(t=ii(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=ko(t,this.array)),t}setW(e,t){return this.normalized&&(t=ii(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=ii(t,this.array),i=ii(i,this.array)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=ii(t,this.array),i=ii(i,this.array),s=ii(s,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=ii(t,this.array),i=ii(i,this.array),s=ii(s,this.array),r=ii(r,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==cf&&(e.usage=this.usage),e}dispose(){this.dispatchEvent({type:"dispose"})}};var Ha=class extends li{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Wa=class extends li{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Dt=class extends li{constructor(e,t,i){super(new Float32Array(e),t,i)}},qM=new nr,Pa=new z,Zd=new z,Vr=class{constructor(e=new z,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):qM.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Pa.subVectors(e,this.center);let t=Pa.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Pa,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Zd.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Pa.copy(e.center).add(Zd)),this.expandByPoint(Pa.copy(e.center).sub(Zd))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},$M=0,Fi=new Gt,Kd=new Ei,Fo=new z,Si=new nr,Ia=new nr,Nn=new z,vn=class n extends ji{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:$M++}),this.uuid=Ko(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(_M(e)?Wa:Ha)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new it().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Fi.makeRotationFromQuaternion(e),this.applyMatrix4(Fi),this}rotateX(e){return Fi.makeRotationX(e),this.applyMatrix4(Fi),this}rotateY(e){return Fi.makeRotationY(e),this.applyMatrix4(Fi),this}rotateZ(e){return Fi.makeRotationZ(e),this.applyMatrix4(Fi),this}translate(e,t,i){return Fi.makeTranslation(e,t,i),this.applyMatrix4(Fi),this}scale(e,t,i){return Fi.makeScale(e,t,i),this.applyMatrix4(Fi),this}lookAt(e){return Kd.lookAt(e),Kd.updateMatrix(),this.applyMatrix4(Kd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Fo).negate(),this.translate(Fo.x,Fo.y,Fo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Dt(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&$e("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new nr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ke("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new z(-1/0,-1/0,-1/0),new z(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];Si.setFromBufferAttribute(r),this.morphTargetsRelative?(Nn.addVectors(this.boundingBox.min,Si.min),this.boundingBox.expandByPoint(Nn),Nn.addVectors(this.boundingBox.max,Si.max),this.boundingBox.expandByPoint(Nn)):(this.boundingBox.expandByPoint(Si.min),this.boundingBox.expandByPoint(Si.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ke('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Vr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ke("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new z,1/0);return}if(e){let i=this.boundingSphere.center;if(Si.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Ia.setFromBufferAttribute(a),this.morphTargetsRelative?(Nn.addVectors(Si.min,Ia.min),Si.expandByPoint(Nn),Nn.addVectors(Si.max,Ia.max),Si.expandByPoint(Nn)):(Si.expandByPoint(Ia.min),Si.expandByPoint(Ia.max))}Si.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Nn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Nn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Nn.fromBufferAttribute(a,c),l&&(Fo.fromBufferAttribute(e,c),Nn.add(Fo)),s=Math.max(s,i.distanceToSquared(Nn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Ke('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Ke("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new li(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[];for(let y=0;y<i.count;y++)a[y]=new z,l[y]=new z;let c=new z,u=new z,d=new z,h=new Je,f=new Je,p=new Je,v=new z,g=new z;function m(y,E,F){c.fromBufferAttribute(i,y),u.fromBufferAttribute(i,E),d.fromBufferAttribute(i,F),h.fromBufferAttribute(r,y),f.fromBufferAttribute(r,E),p.fromBufferAttribute(r,F),u.sub(c),d.sub(c),f.sub(h),p.sub(h);let I=1/(f.x*p.y-p.x*f.y);isFinite(I)&&(v.copy(u).multiplyScalar(p.y).addScaledVector(d,-f.y).multiplyScalar(I),g.copy(d).multiplyScalar(f.x).addScaledVector(u,-p.x).multiplyScalar(I),a[y].add(v),a[E].add(v),a[F].add(v),l[y].add(g),l[E].add(g),l[F].add(g))}let S=this.groups;S.length===0&&(S=[{start:0,count:e.count}]);for(let y=0,E=S.length;y<E;++y){let F=S[y],I=F.start,U=F.count;for(let k=I,X=I+U;k<X;k+=3)m(e.getX(k+0),e.getX(k+1),e.getX(k+2))}let A=new z,b=new z,C=new z,T=new z;function N(y){C.fromBufferAttribute(s,y),T.copy(C);let E=a[y];A.copy(E),A.sub(C.multiplyScalar(C.dot(E))).normalize(),b.crossVectors(T,E);let I=b.dot(l[y])<0?-1:1;o.setXYZW(y,A.x,A.y,A.z,I)}for(let y=0,E=S.length;y<E;++y){let F=S[y],I=F.start,U=F.count;for(let k=I,X=I+U;k<X;k+=3)N(e.getX(k+0)),N(e.getX(k+1)),N(e.getX(k+2))}this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new li(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,f=i.count;h<f;h++)i.setXYZ(h,0,0,0);let s=new z,r=new z,o=new z,a=new z,l=new z,c=new z,u=new z,d=new z;if(e)for(let h=0,f=e.count;h<f;h+=3){let p=e.getX(h+0),v=e.getX(h+1),g=e.getX(h+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,g),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let h=0,f=t.count;h<f;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Nn.fromBufferAttribute(e,t),Nn.normalize(),e.setXYZ(t,Nn.x,Nn.y,Nn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,d=a.normalized,h=new c.constructor(l.length*u),f=0,p=0;for(let v=0,g=l.length;v<g;v++){a.isInterleavedBufferAttribute?f=l[v]*a.data.stride+a.offset:f=l[v]*u;for(let m=0;m<u;m++)h[p++]=c[f++]}return new li(h,u,d)}if(this.index===null)return $e("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,d=c.length;u<d;u++){let h=c[u],f=e(h,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let d=0,h=c.length;d<h;d++){let f=c[d];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],d=r[c];for(let h=0,f=d.length;h<f;h++)u.push(d[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var YM=0,ir=class extends ji{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:YM++}),this.uuid=Ko(),this.name="",this.type="Material",this.blending=kr,this.side=Ji,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Bc,this.blendDst=Vc,this.blendEquation=er,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new xt(0,0,0),this.blendAlpha=0,this.depthFunc=Br,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=lf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ur,this.stencilZFail=Ur,this.stencilZPass=Ur,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){$e(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==kr&&(i.blending=this.blending),this.side!==Ji&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==Bc&&(i.blendSrc=this.blendSrc),this.blendDst!==Vc&&(i.blendDst=this.blendDst),this.blendEquation!==er&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==Br&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==lf&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Ur&&(i.stencilFail=this.stencilFail),this.stencilZFail!==Ur&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==Ur&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.allowOverride===!1&&(i.allowOverride=!1),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new xt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessRange=e.iridescenceThicknessRange),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Je().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Je().fromArray(e.clearcoatNormalScale)),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Cs=new z,Jd=new z,Sc=new z,Js=new z,jd=new z,wc=new z,Qd=new z,zr=class{constructor(e=new z,t=new z(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Cs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Cs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Cs.copy(this.origin).addScaledVector(this.direction,t),Cs.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Jd.copy(e).add(t).multiplyScalar(.5),Sc.copy(t).sub(e).normalize(),Js.copy(this.origin).sub(Jd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Sc),a=Js.dot(this.direction),l=-Js.dot(Sc),c=Js.lengthSq(),u=Math.abs(1-o*o),d,h,f,p;if(u>0)if(d=o*l-a,h=o*a-l,p=r*u,d>=0)if(h>=-p)if(h<=p){let v=1/u;d*=v,h*=v,f=d*(d+o*h+2*a)+h*(o*d+h+2*l)+c}else h=r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;else h=-r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;else h<=-p?(d=Math.max(0,-(-o*r+a)),h=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+h*(h+2*l)+c):h<=p?(d=0,h=Math.min(Math.max(-r,-l),r),f=h*(h+2*l)+c):(d=Math.max(0,-(o*r+a)),h=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+h*(h+2*l)+c);else h=o>0?-r:r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Jd).addScaledVector(Sc,h),f}intersectSphere(e,t){Cs.subVectors(e.center,this.origin);let i=Cs.dot(this.direction),s=Cs.dot(Cs)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,d=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(e.min.z-h.z)*d,l=(e.max.z-h.z)*d):(a=(e.max.z-h.z)*d,l=(e.min.z-h.z)*d),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Cs)!==null}intersectTriangle(e,t,i,s,r){jd.subVectors(t,e),wc.subVectors(i,e),Qd.crossVectors(jd,wc);let o=this.direction.dot(Qd),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;Js.subVectors(this.origin,e);let l=a*this.direction.dot(wc.crossVectors(Js,wc));if(l<0)return null;let c=a*this.direction.dot(jd.cross(Js));if(c<0||l+c>o)return null;let u=-a*Js.dot(Qd);return u<0?null:this.at(u/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Xa=class extends ir{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new xt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new tr,this.combine=gf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},M0=new Gt,Dr=new zr,Tc=new Vr,S0=new z,Ec=new z,Ac=new z,Cc=new z,ef=new z,Rc=new z,w0=new z,Pc=new z,Ft=class extends Ei{constructor(e=new vn,t=new Xa){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Rc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],d=r[l];u!==0&&(ef.fromBufferAttribute(d,e),o?Rc.addScaledVector(ef,u):Rc.addScaledVector(ef.sub(t),u))}t.add(Rc)}return t}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Tc.copy(i.boundingSphere),Tc.applyMatrix4(r),Dr.copy(e.ray).recast(e.near),!(Tc.containsPoint(Dr.origin)===!1&&(Dr.intersectSphere(Tc,S0)===null||Dr.origin.distanceToSquared(S0)>(e.far-e.near)**2))&&(M0.copy(r).invert(),Dr.copy(e.ray).applyMatrix4(M0),!(i.boundingBox!==null&&Dr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Dr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,d=r.attributes.normal,h=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,v=h.length;p<v;p++){let g=h[p],m=o[g.materialIndex],S=Math.max(g.start,f.start),A=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let b=S,C=A;b<C;b+=3){let T=a.getX(b),N=a.getX(b+1),y=a.getX(b+2);s=Ic(this,m,e,i,c,u,d,T,N,y),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(a.count,f.start+f.count);for(let g=p,m=v;g<m;g+=3){let S=a.getX(g),A=a.getX(g+1),b=a.getX(g+2);s=Ic(this,o,e,i,c,u,d,S,A,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,v=h.length;p<v;p++){let g=h[p],m=o[g.materialIndex],S=Math.max(g.start,f.start),A=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let b=S,C=A;b<C;b+=3){let T=b,N=b+1,y=b+2;s=Ic(this,m,e,i,c,u,d,T,N,y),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(l.count,f.start+f.count);for(let g=p,m=v;g<m;g+=3){let S=g,A=g+1,b=g+2;s=Ic(this,o,e,i,c,u,d,S,A,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function ZM(n,e,t,i,s,r,o,a){let l;if(e.side===si?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Ji,a),l===null)return null;Pc.copy(a),Pc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Pc);return c<t.near||c>t.far?null:{distance:c,point:Pc.clone(),object:n}}function Ic(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Ec),n.getVertexPosition(l,Ac),n.getVertexPosition(c,Cc);let u=ZM(n,e,t,i,Ec,Ac,Cc,w0);if(u){let d=new z;Qs.getBarycoord(w0,Ec,Ac,Cc,d),s&&(u.uv=Qs.getInterpolatedAttribute(s,a,l,c,d,new Je)),r&&(u.uv1=Qs.getInterpolatedAttribute(r,a,l,c,d,new Je)),o&&(u.normal=Qs.getInterpolatedAttribute(o,a,l,c,d,new z),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new z,materialIndex:0};Qs.getNormal(Ec,Ac,Cc,h.normal),u.face=h,u.barycoord=d}return u}var Gr=class extends ci{constructor(e=null,t=1,i=1,s,r,o,a,l,c=yn,u=yn,d,h){super(null,o,a,l,c,u,s,r,d,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var qa=class extends li{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var tf=new z,KM=new z,JM=new it,Ui=class{constructor(e=new z(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=tf.subVectors(i,t).cross(KM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(tf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||JM.getNormalMatrix(e),s=this.coplanarPoint(tf).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}},Fr=new Vr,jM=new Je(.5,.5),Lc=new z,$a=class{constructor(e=new Ui,t=new Ui,i=new Ui,s=new Ui,r=new Ui,o=new Ui){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Zi,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],d=r[5],h=r[6],f=r[7],p=r[8],v=r[9],g=r[10],m=r[11],S=r[12],A=r[13],b=r[14],C=r[15];if(s[0].setComponents(c-o,f-u,m-p,C-S).normalize(),s[1].setComponents(c+o,f+u,m+p,C+S).normalize(),s[2].setComponents(c+a,f+d,m+v,C+A).normalize(),s[3].setComponents(c-a,f-d,m-v,C-A).normalize(),i)s[4].setComponents(l,h,g,b).normalize(),s[5].setComponents(c-l,f-h,m-g,C-b).normalize();else if(s[4].setComponents(c-l,f-h,m-g,C-b).normalize(),t===Zi)s[5].setComponents(c+l,f+h,m+g,C+b).normalize();else if(t===ka)s[5].setComponents(l,h,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Fr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Fr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Fr)}intersectsSprite(e){Fr.center.set(0,0,0);let t=jM.distanceTo(e.center);return Fr.radius=.7071067811865476+t,Fr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Fr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Lc.x=s.normal.x>0?e.max.x:e.min.x,Lc.y=s.normal.y>0?e.max.y:e.min.y,Lc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Lc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var Wo=class extends ir{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new xt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},eu=new z,tu=new z,T0=new Gt,La=new zr,Nc=new Vr,nf=new z,E0=new z,Xo=class extends Ei{constructor(e=new vn,t=new Wo){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)eu.fromBufferAttribute(t,s-1),tu.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=eu.distanceTo(tu);e.setAttribute("lineDistance",new Dt(i,1))}else $e("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Nc.copy(i.boundingSphere),Nc.applyMatrix4(s),Nc.radius+=r,e.ray.intersectsSphere(Nc)===!1)return;T0.copy(s).invert(),La.copy(e.ray).applyMatrix4(T0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let v=f,g=p-1;v<g;v+=c){let m=u.getX(v),S=u.getX(v+1),A=Dc(this,e,La,l,m,S,v);A&&t.push(A)}if(this.isLineLoop){let v=u.getX(p-1),g=u.getX(f),m=Dc(this,e,La,l,v,g,p-1);m&&t.push(m)}}else{let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let v=f,g=p-1;v<g;v+=c){let m=Dc(this,e,La,l,v,v+1,v);m&&t.push(m)}if(this.isLineLoop){let v=Dc(this,e,La,l,p-1,f,p-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Dc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(eu.fromBufferAttribute(a,s),tu.fromBufferAttribute(a,r),t.distanceSqToSegment(eu,tu,nf,E0)>i)return;nf.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(nf);if(!(c<e.near||c>e.far))return{distance:c,point:E0.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Ya=class extends ci{constructor(e=[],t=cr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ps=class extends ci{constructor(e,t,i=es,s,r,o,a=yn,l=yn,c,u=us,d=1){if(u!==us&&u!==hr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:d};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Go(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}},nu=class extends Ps{constructor(e,t=es,i=cr,s,r,o=yn,a=yn,l,c=us){let u={width:e,height:e,depth:1},d=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Za=class extends ci{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},hs=class n extends vn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],d=[],h=0,f=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Dt(c,3)),this.setAttribute("normal",new Dt(u,3)),this.setAttribute("uv",new Dt(d,2));function p(v,g,m,S,A,b,C,T,N,y,E){let F=b/N,I=C/y,U=b/2,k=C/2,X=T/2,O=N+1,$=y+1,H=0,ie=0,oe=new z;for(let le=0;le<$;le++){let de=le*I-k;for(let ue=0;ue<O;ue++){let _e=ue*F-U;oe[v]=_e*S,oe[g]=de*A,oe[m]=X,c.push(oe.x,oe.y,oe.z),oe[v]=0,oe[g]=0,oe[m]=T>0?1:-1,u.push(oe.x,oe.y,oe.z),d.push(ue/N),d.push(1-le/y),H+=1}}for(let le=0;le<y;le++)for(let de=0;de<N;de++){let ue=h+de+O*le,_e=h+de+O*(le+1),st=h+(de+1)+O*(le+1),et=h+(de+1)+O*le;l.push(ue,_e,et),l.push(_e,st,et),ie+=6}a.addGroup(f,ie,E),f+=ie,h+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Is=class n extends vn{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],d=[],h=[],f=[],p=0,v=[],g=i/2,m=0;S(),o===!1&&(e>0&&A(!0),t>0&&A(!1)),this.setIndex(u),this.setAttribute("position",new Dt(d,3)),this.setAttribute("normal",new Dt(h,3)),this.setAttribute("uv",new Dt(f,2));function S(){let b=new z,C=new z,T=0,N=(t-e)/i;for(let y=0;y<=r;y++){let E=[],F=y/r,I=F*(t-e)+e;for(let U=0;U<=s;U++){let k=U/s,X=k*l+a,O=Math.sin(X),$=Math.cos(X);C.x=I*O,C.y=-F*i+g,C.z=I*$,d.push(C.x,C.y,C.z),b.set(O,N,$).normalize(),h.push(b.x,b.y,b.z),f.push(k,1-F),E.push(p++)}v.push(E)}for(let y=0;y<s;y++)for(let E=0;E<r;E++){let F=v[E][y],I=v[E+1][y],U=v[E+1][y+1],k=v[E][y+1];(e>0||E!==0)&&(u.push(F,I,k),T+=3),(t>0||E!==r-1)&&(u.push(I,U,k),T+=3)}c.addGroup(m,T,0),m+=T}function A(b){let C=p,T=new Je,N=new z,y=0,E=b===!0?e:t,F=b===!0?1:-1;for(let U=1;U<=s;U++)d.push(0,g*F,0),h.push(0,F,0),f.push(.5,.5),p++;let I=p;for(let U=0;U<=s;U++){let X=U/s*l+a,O=Math.cos(X),$=Math.sin(X);N.x=E*$,N.y=g*F,N.z=E*O,d.push(N.x,N.y,N.z),h.push(0,F,0),T.x=O*.5+.5,T.y=$*.5*F+.5,f.push(T.x,T.y),p++}for(let U=0;U<s;U++){let k=C+U,X=I+U;b===!0?u.push(X,X+1,k):u.push(X+1,X,k),y+=3}c.addGroup(m,y,b===!0?1:2),m+=y}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Hr=class n extends vn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,d=e/a,h=t/l,f=[],p=[],v=[],g=[];for(let m=0;m<u;m++){let S=m*h-o;for(let A=0;A<c;A++){let b=A*d-r;p.push(b,-S,0),v.push(0,0,1),g.push(A/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let S=0;S<a;S++){let A=S+c*m,b=S+c*(m+1),C=S+1+c*(m+1),T=S+1+c*m;f.push(A,b,T),f.push(b,C,T)}this.setIndex(f),this.setAttribute("position",new Dt(p,3)),this.setAttribute("normal",new Dt(v,3)),this.setAttribute("uv",new Dt(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var Ka=class n extends vn{constructor(e=1,t=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],d=[],h=new z,f=new z,p=new z;for(let v=0;v<=i;v++){let g=o+v/i*a;for(let m=0;m<=s;m++){let S=m/s*r;f.x=(e+t*Math.cos(g))*Math.cos(S),f.y=(e+t*Math.cos(g))*Math.sin(S),f.z=t*Math.sin(g),c.push(f.x,f.y,f.z),h.x=e*Math.cos(S),h.y=e*Math.sin(S),p.subVectors(f,h).normalize(),u.push(p.x,p.y,p.z),d.push(m/s),d.push(v/i)}}for(let v=1;v<=i;v++)for(let g=1;g<=s;g++){let m=(s+1)*v+g-1,S=(s+1)*(v-1)+g-1,A=(s+1)*(v-1)+g,b=(s+1)*v+g;l.push(m,S,b),l.push(S,A,b)}this.setIndex(l),this.setAttribute("position",new Dt(c,3)),this.setAttribute("normal",new Dt(u,3)),this.setAttribute("uv",new Dt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc)}};function Xr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(A0(s))s.isRenderTargetTexture?($e("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(A0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function qn(n){let e={};for(let t=0;t<n.length;t++){let i=Xr(n[t]);for(let s in i)e[s]=i[s]}return e}function A0(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function QM(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Of(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:_t.workingColorSpace}var f_={clone:Xr,merge:qn},eS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,tS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ln=class extends ir{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=eS,this.fragmentShader=tS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Xr(e.uniforms),this.uniformsGroups=QM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new xt().setHex(s.value);break;case"v2":this.uniforms[i].value=new Je().fromArray(s.value);break;case"v3":this.uniforms[i].value=new z().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Qt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new it().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Gt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},iu=class extends ln{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var su=class extends ir{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=e_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},ru=class extends ir{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Fc(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}var sr=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},ou=class extends sr{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:rf,endingEnd:rf}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case of:r=e,a=2*t-i;break;case af:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case of:o=e,l=2*i-t;break;case af:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,d=this._offsetNext,h=this._weightPrev,f=this._weightNext,p=(i-t)/(s-t),v=p*p,g=v*p,m=-h*g+2*h*v-h*p,S=(1+h)*g+(-1.5-2*h)*v+(-.5+h)*p+1,A=(-1-f)*g+(1.5+f)*v+.5*p,b=f*g-f*v;for(let C=0;C!==a;++C)r[C]=m*o[u+C]+S*o[c+C]+A*o[l+C]+b*o[d+C];return r}},au=class extends sr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),d=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*d+o[l+h]*u;return r}},lu=class extends sr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},cu=class extends sr{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,d=this.outTangents;if(!u||!d){let p=(i-t)/(s-t),v=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*v+o[l+g]*p;return r}let h=a*2,f=e-1;for(let p=0;p!==a;++p){let v=o[c+p],g=o[l+p],m=f*h+p*2,S=d[m],A=d[m+1],b=e*h+p*2,C=u[b],T=u[b+1],N=(i-t)/(s-t),y,E,F,I,U;for(let k=0;k<8;k++){y=N*N,E=y*N,F=1-N,I=F*F,U=I*F;let O=U*t+3*I*N*S+3*F*y*C+E*s-i;if(Math.abs(O)<1e-10)break;let $=3*I*(S-t)+6*F*N*(C-S)+3*y*(s-C);if(Math.abs($)<1e-10)break;N=N-O/$,N=Math.max(0,Math.min(1,N))}r[p]=U*v+3*I*N*A+3*F*y*T+E*g}return r}},Ai=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Fc(t,this.TimeBufferType),this.values=Fc(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Fc(e.times,Array),values:Fc(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s)}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new lu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new au(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new ou(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new cu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Fa:t=this.InterpolantFactoryMethodDiscrete;break;case Kc:t=this.InterpolantFactoryMethodLinear;break;case kc:t=this.InterpolantFactoryMethodSmooth;break;case sf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return $e("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Fa;case this.InterpolantFactoryMethodLinear:return Kc;case this.InterpolantFactoryMethodSmooth:return kc;case this.InterpolantFactoryMethodBezier:return sf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Ke("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Ke("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Ke("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Ke("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&xM(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Ke("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===kc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let d=a*i,h=d-i,f=d+i;for(let p=0;p!==i;++p){let v=t[d+p];if(v!==t[h+p]||v!==t[f+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let d=a*i,h=o*i;for(let f=0;f!==i;++f)t[h+f]=t[d+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,s}};Ai.prototype.ValueTypeName="";Ai.prototype.TimeBufferType=Float32Array;Ai.prototype.ValueBufferType=Float32Array;Ai.prototype.DefaultInterpolation=Kc;var rr=class extends Ai{constructor(e,t,i){super(e,t,i)}};rr.prototype.ValueTypeName="bool";rr.prototype.ValueBufferType=Array;rr.prototype.DefaultInterpolation=Fa;rr.prototype.InterpolantFactoryMethodLinear=void 0;rr.prototype.InterpolantFactoryMethodSmooth=void 0;var uu=class extends Ai{constructor(e,t,i,s){super(e,t,i,s)}};uu.prototype.ValueTypeName="color";var hu=class extends Ai{constructor(e,t,i,s){super(e,t,i,s)}};hu.prototype.ValueTypeName="number";var du=class extends sr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Xn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ja=class extends Ai{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new du(this.times,this.values,this.getValueSize(),e)}};Ja.prototype.ValueTypeName="quaternion";Ja.prototype.InterpolantFactoryMethodSmooth=void 0;var or=class extends Ai{constructor(e,t,i){super(e,t,i)}};or.prototype.ValueTypeName="string";or.prototype.ValueBufferType=Array;or.prototype.DefaultInterpolation=Fa;or.prototype.InterpolantFactoryMethodLinear=void 0;or.prototype.InterpolantFactoryMethodSmooth=void 0;var fu=class extends Ai{constructor(e,t,i,s){super(e,t,i,s)}};fu.prototype.ValueTypeName="vector";var pu=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,d){return c.push(u,d),this},this.removeHandler=function(u){let d=c.indexOf(u);return d!==-1&&c.splice(d,2),this},this.getHandler=function(u){for(let d=0,h=c.length;d<h;d+=2){let f=c[d],p=c[d+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},p_=new pu,mu=class{constructor(e){this.manager=e!==void 0?e:p_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}abort(){return this}};mu.DEFAULT_MATERIAL_NAME="__DEFAULT";var Uc=new z,Oc=new Xn,ls=new z,ja=class extends Ei{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Gt,this.projectionMatrix=new Gt,this.projectionMatrixInverse=new Gt,this.coordinateSystem=Zi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Uc,Oc,ls),ls.x===1&&ls.y===1&&ls.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Uc,Oc,ls.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Uc,Oc,ls),ls.x===1&&ls.y===1&&ls.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Uc,Oc,ls.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},js=new z,C0=new Je,R0=new Je,Wn=class extends ja{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=zo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Na*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return zo*2*Math.atan(Math.tan(Na*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){js.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(js.x,js.y).multiplyScalar(-e/js.z),js.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(js.x,js.y).multiplyScalar(-e/js.z)}getViewSize(e,t){return this.getViewBounds(e,C0,R0),t.subVectors(R0,C0)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Na*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Qa=class extends ja{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var el=class extends vn{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Uo=-90,Oo=1,gu=class extends Ei{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Wn(Uo,Oo,e,t);s.layers=this.layers,this.add(s);let r=new Wn(Uo,Oo,e,t);r.layers=this.layers,this.add(r);let o=new Wn(Uo,Oo,e,t);o.layers=this.layers,this.add(o);let a=new Wn(Uo,Oo,e,t);a.layers=this.layers,this.add(a);let l=new Wn(Uo,Oo,e,t);l.layers=this.layers,this.add(l);let c=new Wn(Uo,Oo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Zi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===ka)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,d=e.getRenderTarget(),h=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let v=i.texture.generateMipmaps;i.texture.generateMipmaps=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.generateMipmaps=v,e.setRenderTarget(i,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(d,h,f),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},_u=class extends Wn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}};var kf="\\[\\]\\.:\\/",nS=new RegExp("["+kf+"]","g"),Bf="[^"+kf+"]",iS="[^"+kf.replace("\\.","")+"]",sS=/((?:WC+[\/:])*)/.source.replace("WC",Bf),rS=/(WCOD+)?/.source.replace("WCOD",iS),oS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Bf),aS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Bf),lS=new RegExp("^"+sS+rS+oS+aS+"$"),cS=["material","materials","bones","map"],uf=class{constructor(e,t,i){let s=i||jt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},jt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(nS,"")}static parseTrackName(e){let t=lS.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);cS.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){$e("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){Ke("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Ke("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Ke("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Ke("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Ke("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){Ke("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){Ke("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Ke("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Ke("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Ke("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};jt.Composite=uf;jt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};jt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};jt.prototype.GetterByBindingType=[jt.prototype._getValue_direct,jt.prototype._getValue_array,jt.prototype._getValue_arrayElement,jt.prototype._getValue_toArray];jt.prototype.SetterByBindingTypeAndVersioning=[[jt.prototype._setValue_direct,jt.prototype._setValue_direct_setNeedsUpdate,jt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_array,jt.prototype._setValue_array_setNeedsUpdate,jt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_arrayElement,jt.prototype._setValue_arrayElement_setNeedsUpdate,jt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_fromArray,jt.prototype._setValue_fromArray_setNeedsUpdate,jt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var b3=new Float32Array(1);var qo=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ut(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(ut(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var hf=class n{static{n.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var tl=class extends ji{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){if(e===void 0){$e("Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Vf(n,e,t,i){let s=uS(i);switch(t){case Rf:return n*e;case If:return n*e/s.components*s.byteLength;case wu:return n*e/s.components*s.byteLength;case dr:return n*e*2/s.components*s.byteLength;case Tu:return n*e*2/s.components*s.byteLength;case Pf:return n*e*3/s.components*s.byteLength;case ri:return n*e*4/s.components*s.byteLength;case Eu:return n*e*4/s.components*s.byteLength;case rl:case ol:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case al:case ll:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Cu:case Pu:return Math.max(n,16)*Math.max(e,8)/4;case Au:case Ru:return Math.max(n,8)*Math.max(e,8)/2;case Iu:case Lu:case Du:case Fu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Nu:case cl:case Uu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ou:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case ku:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Bu:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Vu:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case zu:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Gu:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Hu:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Wu:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Xu:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case qu:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case $u:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Yu:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Zu:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Ku:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Ju:case ju:case Qu:return Math.ceil(n/4)*Math.ceil(e/4)*16;case eh:case th:return Math.ceil(n/4)*Math.ceil(e/4)*8;case ul:case nh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function uS(n){switch(n){case Ci:case Tf:return{byteLength:1,components:1};case Yo:case Ef:case fs:return{byteLength:2,components:1};case Mu:case Su:return{byteLength:2,components:4};case es:case bu:case Ri:return{byteLength:4,components:1};case Af:case Cf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"185"}}));typeof window<"u"&&(window.__THREE__?$e("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="185");function O_(){let n=null,e=!1,t=null,i=null;function s(r,o){t(r,o),i=n.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function dS(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,d=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let u=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,u);else{d.sort((f,p)=>f.start-p.start);let h=0;for(let f=1;f<d.length;f++){let p=d[h],v=d[f];v.start<=p.start+p.count+1?p.count=Math.max(p.count,v.start+v.count-p.start):(++h,d[h]=v)}d.length=h+1;for(let f=0,p=d.length;f<p;f++){let v=d[f];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var fS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,pS=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,mS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,gS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,_S=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,xS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,yS=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,vS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,bS=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,MS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,SS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,wS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,TS=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,ES=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,AS=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,CS=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,RS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,PS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,IS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,LS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,NS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,DS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,FS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,US=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,OS=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,kS=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,BS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,VS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,zS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,GS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,HS="gl_FragColor = linearToOutputTexel( gl_FragColor );",WS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,XS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,qS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
#endif`,$S=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,YS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,ZS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,KS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,JS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,jS=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,QS=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,ew=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,tw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,nw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,iw=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,sw=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,rw=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,ow=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,aw=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,lw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,cw=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,uw=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,hw=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
		vec3 iridescenceFresnelDielectric;
		vec3 iridescenceFresnelMetallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
vec3 BRDF_GGX_Multiscatter( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 singleScatter = BRDF_GGX( lightDir, viewDir, normal, material );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 dfgV = texture2D( dfgLUT, vec2( material.roughness, dotNV ) ).rg;
	vec2 dfgL = texture2D( dfgLUT, vec2( material.roughness, dotNL ) ).rg;
	vec3 FssEss_V = material.specularColorBlended * dfgV.x + material.specularF90 * dfgV.y;
	vec3 FssEss_L = material.specularColorBlended * dfgL.x + material.specularF90 * dfgL.y;
	float Ess_V = dfgV.x + dfgV.y;
	float Ess_L = dfgL.x + dfgL.y;
	float Ems_V = 1.0 - Ess_V;
	float Ems_L = 1.0 - Ess_L;
	vec3 Favg = material.specularColorBlended + ( 1.0 - material.specularColorBlended ) * 0.047619;
	vec3 Fms = FssEss_V * FssEss_L * Favg / ( 1.0 - Ems_V * Ems_L * Favg + EPSILON );
	float compensationFactor = Ems_V * Ems_L;
	vec3 multiScatter = Fms * compensationFactor;
	return singleScatter + multiScatter;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX_Multiscatter( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseContribution );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution );
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnelDielectric, material.roughness, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceFresnelMetallic, material.roughness, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( geometryNormal, geometryViewDir, material.diffuseColor, material.specularF90, material.roughness, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,dw=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( material.iridescenceFresnelDielectric, material.iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#ifdef USE_LIGHT_PROBES_GRID
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		irradiance += getLightProbeGridIrradiance( probeWorldPos, probeWorldNormal );
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,fw=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_CUBE_UV )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,pw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,mw=`#ifdef USE_LIGHT_PROBES_GRID
uniform highp sampler3D probesSH;
uniform vec3 probesMin;
uniform vec3 probesMax;
uniform vec3 probesResolution;
vec3 getLightProbeGridIrradiance( vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 resMinusOne = res - 1.0;
	vec3 probeSpacing = gridRange / resMinusOne;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.0, 1.0 );
	uvw = uvw * resMinusOne / res + 0.5 / res;
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,gw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,_w=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,xw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,yw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,vw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,bw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Mw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Sw=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ww=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Tw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Ew=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Aw=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Cw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Rw=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Pw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Iw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Lw=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Nw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Dw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Fw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Uw=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Ow=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,kw=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Bw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Vw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,zw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Gw=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Hw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Ww=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Xw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,qw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,$w=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Yw=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Zw=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			shadowCoord.z += shadowBias;
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				float radius = shadowRadius * texelSize.x;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float dp = ( shadowCameraNear * ( shadowCameraFar - viewSpaceZ ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
				dp -= shadowBias;
			#else
				float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
				dp += shadowBias;
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			vec2 sample0 = vogelDiskSample( 0, 5, phi );
			vec2 sample1 = vogelDiskSample( 1, 5, phi );
			vec2 sample2 = vogelDiskSample( 2, 5, phi );
			vec2 sample3 = vogelDiskSample( 3, 5, phi );
			vec2 sample4 = vogelDiskSample( 4, 5, phi );
			shadow = (
				texture( shadowMap, vec4( bd3D + ( tangent * sample0.x + bitangent * sample0.y ) * texelSize, dp ) ) +
				texture( shadowMap, vec4( bd3D + ( tangent * sample1.x + bitangent * sample1.y ) * texelSize, dp ) ) +
				texture( shadowMap, vec4( bd3D + ( tangent * sample2.x + bitangent * sample2.y ) * texelSize, dp ) ) +
				texture( shadowMap, vec4( bd3D + ( tangent * sample3.x + bitangent * sample3.y ) * texelSize, dp ) ) +
				texture( shadowMap, vec4( bd3D + ( tangent * sample4.x + bitangent * sample4.y ) * texelSize, dp ) )
			) * 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Kw=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Jw=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,jw=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Qw=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,e1=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,t1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,n1=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,i1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,s1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,r1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,o1=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,a1=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,l1=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,c1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,u1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,h1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,d1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,f1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,p1=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,m1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,g1=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,_1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,x1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,y1=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,v1=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,b1=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,M1=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,S1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,w1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,T1=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,E1=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,A1=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,C1=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,R1=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,P1=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,I1=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,L1=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,N1=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,D1=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,F1=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,U1=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,O1=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,k1=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,B1=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,V1=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,z1=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,G1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,H1=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,W1=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,X1=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,q1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,at={alphahash_fragment:fS,alphahash_pars_fragment:pS,alphamap_fragment:mS,alphamap_pars_fragment:gS,alphatest_fragment:_S,alphatest_pars_fragment:xS,aomap_fragment:yS,aomap_pars_fragment:vS,batching_pars_vertex:bS,batching_vertex:MS,begin_vertex:SS,beginnormal_vertex:wS,bsdfs:TS,iridescence_fragment:ES,bumpmap_pars_fragment:AS,clipping_planes_fragment:CS,clipping_planes_pars_fragment:RS,clipping_planes_pars_vertex:PS,clipping_planes_vertex:IS,color_fragment:LS,color_pars_fragment:NS,color_pars_vertex:DS,color_vertex:FS,common:US,cube_uv_reflection_fragment:OS,defaultnormal_vertex:kS,displacementmap_pars_vertex:BS,displacementmap_vertex:VS,emissivemap_fragment:zS,emissivemap_pars_fragment:GS,colorspace_fragment:HS,colorspace_pars_fragment:WS,envmap_fragment:XS,envmap_common_pars_fragment:qS,envmap_pars_fragment:$S,envmap_pars_vertex:YS,envmap_physical_pars_fragment:rw,envmap_vertex:ZS,fog_vertex:KS,fog_pars_vertex:JS,fog_fragment:jS,fog_pars_fragment:QS,gradientmap_pars_fragment:ew,lightmap_pars_fragment:tw,lights_lambert_fragment:nw,lights_lambert_pars_fragment:iw,lights_pars_begin:sw,lights_toon_fragment:ow,lights_toon_pars_fragment:aw,lights_phong_fragment:lw,lights_phong_pars_fragment:cw,lights_physical_fragment:uw,lights_physical_pars_fragment:hw,lights_fragment_begin:dw,lights_fragment_maps:fw,lights_fragment_end:pw,lightprobes_pars_fragment:mw,logdepthbuf_fragment:gw,logdepthbuf_pars_fragment:_w,logdepthbuf_pars_vertex:xw,logdepthbuf_vertex:yw,map_fragment:vw,map_pars_fragment:bw,map_particle_fragment:Mw,map_particle_pars_fragment:Sw,metalnessmap_fragment:ww,metalnessmap_pars_fragment:Tw,morphinstance_vertex:Ew,morphcolor_vertex:Aw,morphnormal_vertex:Cw,morphtarget_pars_vertex:Rw,morphtarget_vertex:Pw,normal_fragment_begin:Iw,normal_fragment_maps:Lw,normal_pars_fragment:Nw,normal_pars_vertex:Dw,normal_vertex:Fw,normalmap_pars_fragment:Uw,clearcoat_normal_fragment_begin:Ow,clearcoat_normal_fragment_maps:kw,clearcoat_pars_fragment:Bw,iridescence_pars_fragment:Vw,opaque_fragment:zw,packing:Gw,premultiplied_alpha_fragment:Hw,project_vertex:Ww,dithering_fragment:Xw,dithering_pars_fragment:qw,roughnessmap_fragment:$w,roughnessmap_pars_fragment:Yw,shadowmap_pars_fragment:Zw,shadowmap_pars_vertex:Kw,shadowmap_vertex:Jw,shadowmask_pars_fragment:jw,skinbase_vertex:Qw,skinning_pars_vertex:e1,skinning_vertex:t1,skinnormal_vertex:n1,specularmap_fragment:i1,specularmap_pars_fragment:s1,tonemapping_fragment:r1,tonemapping_pars_fragment:o1,transmission_fragment:a1,transmission_pars_fragment:l1,uv_pars_fragment:c1,uv_pars_vertex:u1,uv_vertex:h1,worldpos_vertex:d1,background_vert:f1,background_frag:p1,backgroundCube_vert:m1,backgroundCube_frag:g1,cube_vert:_1,cube_frag:x1,depth_vert:y1,depth_frag:v1,distance_vert:b1,distance_frag:M1,equirect_vert:S1,equirect_frag:w1,linedashed_vert:T1,linedashed_frag:E1,meshbasic_vert:A1,meshbasic_frag:C1,meshlambert_vert:R1,meshlambert_frag:P1,meshmatcap_vert:I1,meshmatcap_frag:L1,meshnormal_vert:N1,meshnormal_frag:D1,meshphong_vert:F1,meshphong_frag:U1,meshphysical_vert:O1,meshphysical_frag:k1,meshtoon_vert:B1,meshtoon_frag:V1,points_vert:z1,points_frag:G1,shadow_vert:H1,shadow_frag:W1,sprite_vert:X1,sprite_frag:q1},Ee={common:{diffuse:{value:new xt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new it}},envmap:{envMap:{value:null},envMapRotation:{value:new it},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new it}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new it}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new it},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new it},normalScale:{value:new Je(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new it},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new it}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new it}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new it}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new xt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:null},probesMin:{value:new z},probesMax:{value:new z},probesResolution:{value:new z}},points:{diffuse:{value:new xt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0},uvTransform:{value:new it}},sprite:{diffuse:{value:new xt(16777215)},opacity:{value:1},center:{value:new Je(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}}},ms={basic:{uniforms:qn([Ee.common,Ee.specularmap,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.fog]),vertexShader:at.meshbasic_vert,fragmentShader:at.meshbasic_frag},lambert:{uniforms:qn([Ee.common,Ee.specularmap,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.fog,Ee.lights,{emissive:{value:new xt(0)},envMapIntensity:{value:1}}]),vertexShader:at.meshlambert_vert,fragmentShader:at.meshlambert_frag},phong:{uniforms:qn([Ee.common,Ee.specularmap,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.fog,Ee.lights,{emissive:{value:new xt(0)},specular:{value:new xt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:at.meshphong_vert,fragmentShader:at.meshphong_frag},standard:{uniforms:qn([Ee.common,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.roughnessmap,Ee.metalnessmap,Ee.fog,Ee.lights,{emissive:{value:new xt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag},toon:{uniforms:qn([Ee.common,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.gradientmap,Ee.fog,Ee.lights,{emissive:{value:new xt(0)}}]),vertexShader:at.meshtoon_vert,fragmentShader:at.meshtoon_frag},matcap:{uniforms:qn([Ee.common,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.fog,{matcap:{value:null}}]),vertexShader:at.meshmatcap_vert,fragmentShader:at.meshmatcap_frag},points:{uniforms:qn([Ee.points,Ee.fog]),vertexShader:at.points_vert,fragmentShader:at.points_frag},dashed:{uniforms:qn([Ee.common,Ee.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:at.linedashed_vert,fragmentShader:at.linedashed_frag},depth:{uniforms:qn([Ee.common,Ee.displacementmap]),vertexShader:at.depth_vert,fragmentShader:at.depth_frag},normal:{uniforms:qn([Ee.common,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,{opacity:{value:1}}]),vertexShader:at.meshnormal_vert,fragmentShader:at.meshnormal_frag},sprite:{uniforms:qn([Ee.sprite,Ee.fog]),vertexShader:at.sprite_vert,fragmentShader:at.sprite_frag},background:{uniforms:{uvTransform:{value:new it},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:at.background_vert,fragmentShader:at.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new it}},vertexShader:at.backgroundCube_vert,fragmentShader:at.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:at.cube_vert,fragmentShader:at.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:at.equirect_vert,fragmentShader:at.equirect_frag},distance:{uniforms:qn([Ee.common,Ee.displacementmap,{referencePosition:{value:new z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:at.distance_vert,fragmentShader:at.distance_frag},shadow:{uniforms:qn([Ee.lights,Ee.fog,{color:{value:new xt(0)},opacity:{value:1}}]),vertexShader:at.shadow_vert,fragmentShader:at.shadow_frag}};ms.physical={uniforms:qn([ms.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new it},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new it},clearcoatNormalScale:{value:new Je(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new it},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new it},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new it},sheen:{value:0},sheenColor:{value:new xt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new it},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new it},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new it},transmissionSamplerSize:{value:new Je},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new it},attenuationDistance:{value:0},attenuationColor:{value:new xt(0)},specularColor:{value:new xt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new it},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new it},anisotropyVector:{value:new Je},anisotropyMap:{value:null},anisotropyMapTransform:{value:new it}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag};var rh={r:0,b:0,g:0},$1=new Gt,k_=new it;k_.set(-1,0,0,0,1,0,0,0,1);function Y1(n,e,t,i,s,r){let o=new xt(0),a=s===!0?0:1,l,c,u=null,d=0,h=null;function f(S){let A=S.isScene===!0?S.background:null;if(A&&A.isTexture){let b=S.backgroundBlurriness>0;A=e.get(A,b)}return A}function p(S){let A=!1,b=f(S);b===null?g(o,a):b&&b.isColor&&(g(b,1),A=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function v(S,A){let b=f(A);b&&(b.isCubeTexture||b.mapping===il)?(c===void 0&&(c=new Ft(new hs(1,1,1),new ln({name:"BackgroundCubeMaterial",uniforms:Xr(ms.backgroundCube.uniforms),vertexShader:ms.backgroundCube.vertexShader,fragmentShader:ms.backgroundCube.fragmentShader,side:si,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,T,N){this.matrixWorld.copyPosition(N.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4($1.makeRotationFromEuler(A.backgroundRotation)).transpose(),b.isCubeTexture&&b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(k_),c.material.toneMapped=_t.getTransfer(b.colorSpace)!==Nt,(u!==b||d!==b.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,d=b.version,h=n.toneMapping),c.layers.enableAll(),S.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Ft(new Hr(2,2),new ln({name:"BackgroundMaterial",uniforms:Xr(ms.background.uniforms),vertexShader:ms.background.vertexShader,fragmentShader:ms.background.fragmentShader,side:Ji,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=_t.getTransfer(b.colorSpace)!==Nt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||d!==b.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,d=b.version,h=n.toneMapping),l.layers.enableAll(),S.unshift(l,l.geometry,l.material,0,0,null))}function g(S,A){S.getRGB(rh,Of(n)),t.buffers.color.setClear(rh.r,rh.g,rh.b,A,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(S,A=1){o.set(S),a=A,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(S){a=S,g(o,a)},render:p,addToRenderList:v,dispose:m}}function Z1(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(I,U,k,X,O){let $=!1,H=d(I,X,k,U);r!==H&&(r=H,c(r.object)),$=f(I,X,k,O),$&&p(I,X,k,O),O!==null&&e.update(O,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,b(I,U,k,X),O!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(O).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function u(I){return n.deleteVertexArray(I)}function d(I,U,k,X){let O=X.wireframe===!0,$=i[U.id];$===void 0&&($={},i[U.id]=$);let H=I.isInstancedMesh===!0?I.id:0,ie=$[H];ie===void 0&&(ie={},$[H]=ie);let oe=ie[k.id];oe===void 0&&(oe={},ie[k.id]=oe);let le=oe[O];return le===void 0&&(le=h(l()),oe[O]=le),le}function h(I){let U=[],k=[],X=[];for(let O=0;O<t;O++)U[O]=0,k[O]=0,X[O]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:U,enabledAttributes:k,attributeDivisors:X,object:I,attributes:{},index:null}}function f(I,U,k,X){let O=r.attributes,$=U.attributes,H=0,ie=k.getAttributes();for(let oe in ie)if(ie[oe].location>=0){let de=O[oe],ue=$[oe];if(ue===void 0&&(oe==="instanceMatrix"&&I.instanceMatrix&&(ue=I.instanceMatrix),oe==="instanceColor"&&I.instanceColor&&(ue=I.instanceColor)),de===void 0||de.attribute!==ue||ue&&de.data!==ue.data)return!0;H++}return r.attributesNum!==H||r.index!==X}function p(I,U,k,X){let O={},$=U.attributes,H=0,ie=k.getAttributes();for(let oe in ie)if(ie[oe].location>=0){let de=$[oe];de===void 0&&(oe==="instanceMatrix"&&I.instanceMatrix&&(de=I.instanceMatrix),oe==="instanceColor"&&I.instanceColor&&(de=I.instanceColor));let ue={};ue.attribute=de,de&&de.data&&(ue.data=de.data),O[oe]=ue,H++}r.attributes=O,r.attributesNum=H,r.index=X}function v(){let I=r.newAttributes;for(let U=0,k=I.length;U<k;U++)I[U]=0}function g(I){m(I,0)}function m(I,U){let k=r.newAttributes,X=r.enabledAttributes,O=r.attributeDivisors;k[I]=1,X[I]===0&&(n.enableVertexAttribArray(I),X[I]=1),O[I]!==U&&(n.vertexAttribDivisor(I,U),O[I]=U)}function S(){let I=r.newAttributes,U=r.enabledAttributes;for(let k=0,X=U.length;k<X;k++)U[k]!==I[k]&&(n.disableVertexAttribArray(k),U[k]=0)}function A(I,U,k,X,O,$,H){H===!0?n.vertexAttribIPointer(I,U,k,O,$):n.vertexAttribPointer(I,U,k,X,O,$)}function b(I,U,k,X){v();let O=X.attributes,$=k.getAttributes(),H=U.defaultAttributeValues;for(let ie in $){let oe=$[ie];if(oe.location>=0){let le=O[ie];if(le===void 0&&(ie==="instanceMatrix"&&I.instanceMatrix&&(le=I.instanceMatrix),ie==="instanceColor"&&I.instanceColor&&(le=I.instanceColor)),le!==void 0){let de=le.normalized,ue=le.itemSize,_e=e.get(le);if(_e===void 0)continue;let st=_e.buffer,et=_e.type,Q=_e.bytesPerElement,ae=et===n.INT||et===n.UNSIGNED_INT||le.gpuType===bu;if(le.isInterleavedBufferAttribute){let he=le.data,Ve=he.stride,De=le.offset;if(he.isInstancedInterleavedBuffer){for(let ke=0;ke<oe.locationSize;ke++)m(oe.location+ke,he.meshPerAttribute);I.isInstancedMesh!==!0&&X._maxInstanceCount===void 0&&(X._maxInstanceCount=he.meshPerAttribute*he.count)}else for(let ke=0;ke<oe.locationSize;ke++)g(oe.location+ke);n.bindBuffer(n.ARRAY_BUFFER,st);for(let ke=0;ke<oe.locationSize;ke++)A(oe.location+ke,ue/oe.locationSize,et,de,Ve*Q,(De+ue/oe.locationSize*ke)*Q,ae)}else{if(le.isInstancedBufferAttribute){for(let he=0;he<oe.locationSize;he++)m(oe.location+he,le.meshPerAttribute);I.isInstancedMesh!==!0&&X._maxInstanceCount===void 0&&(X._maxInstanceCount=le.meshPerAttribute*le.count)}else for(let he=0;he<oe.locationSize;he++)g(oe.location+he);n.bindBuffer(n.ARRAY_BUFFER,st);for(let he=0;he<oe.locationSize;he++)A(oe.location+he,ue/oe.locationSize,et,de,ue*Q,ue/oe.locationSize*he*Q,ae)}}else if(H!==void 0){let de=H[ie];if(de!==void 0)switch(de.length){case 2:n.vertexAttrib2fv(oe.location,de);break;case 3:n.vertexAttrib3fv(oe.location,de);break;case 4:n.vertexAttrib4fv(oe.location,de);break;default:n.vertexAttrib1fv(oe.location,de)}}}}S()}function C(){E();for(let I in i){let U=i[I];for(let k in U){let X=U[k];for(let O in X){let $=X[O];for(let H in $)u($[H].object),delete $[H];delete X[O]}}delete i[I]}}function T(I){if(i[I.id]===void 0)return;let U=i[I.id];for(let k in U){let X=U[k];for(let O in X){let $=X[O];for(let H in $)u($[H].object),delete $[H];delete X[O]}}delete i[I.id]}function N(I){for(let U in i){let k=i[U];for(let X in k){let O=k[X];if(O[I.id]===void 0)continue;let $=O[I.id];for(let H in $)u($[H].object),delete $[H];delete O[I.id]}}}function y(I){for(let U in i){let k=i[U],X=I.isInstancedMesh===!0?I.id:0,O=k[X];if(O!==void 0){for(let $ in O){let H=O[$];for(let ie in H)u(H[ie].object),delete H[ie];delete O[$]}delete k[X],Object.keys(k).length===0&&delete i[U]}}}function E(){F(),o=!0,r!==s&&(r=s,c(r.object))}function F(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:E,resetDefaultState:F,dispose:C,releaseStatesOfGeometry:T,releaseStatesOfObject:y,releaseStatesOfProgram:N,initAttributes:v,enableAttribute:g,disableUnusedAttributes:S}}function K1(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let f=0;f<u;f++)h+=c[f];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function J1(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let N=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(N.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(N){return!(N!==ri&&i.convert(N)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(N){let y=N===fs&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(N!==Ci&&i.convert(N)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&N!==Ri&&!y)}function l(N){if(N==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";N="mediump"}return N==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&($e("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let d=t.logarithmicDepthBuffer===!0,h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control");t.reversedDepthBuffer===!0&&h===!1&&$e("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),S=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),A=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),T=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:p,maxTextureSize:v,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:S,maxVaryings:A,maxFragmentUniforms:b,maxSamples:C,samples:T}}function j1(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Ui,a=new it,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,h){let f=d.length!==0||h||i!==0||s;return s=h,i=d.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,h){t=u(d,h,0)},this.setState=function(d,h,f){let p=d.clippingPlanes,v=d.clipIntersection,g=d.clipShadows,m=n.get(d);if(!s||p===null||p.length===0||r&&!g)r?u(null):c();else{let S=r?0:i,A=S*4,b=m.clippingState||null;l.value=b,b=u(p,h,A,f);for(let C=0;C!==A;++C)b[C]=t[C];m.clippingState=b,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=S}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(d,h,f,p){let v=d!==null?d.length:0,g=null;if(v!==0){if(g=l.value,p!==!0||g===null){let m=f+v*4,S=h.matrixWorldInverse;a.getNormalMatrix(S),(g===null||g.length<m)&&(g=new Float32Array(m));for(let A=0,b=f;A!==v;++A,b+=4)o.copy(d[A]).applyMatrix4(S,a),o.normal.toArray(g,b),g[b+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,g}}var fr=4,m_=[.125,.215,.35,.446,.526,.582],qr=20,Q1=256,hl=new Qa,g_=new xt,zf=null,Gf=0,Hf=0,Wf=!1,eT=new z,ah=class{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._sizeLods=[],this._sigmas=[],this._lodMeshes=[],this._backgroundBox=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=eT}=r;zf=this._renderer.getRenderTarget(),Gf=this._renderer.getActiveCubeFace(),Hf=this._renderer.getActiveMipmapLevel(),Wf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(e,i,s,l,a),t>0&&this._blur(l,0,0,t),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=y_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=x_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._backgroundBox!==null&&(this._backgroundBox.geometry.dispose(),this._backgroundBox.material.dispose())}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodMeshes.length;e++)this._lodMeshes[e].geometry.dispose()}_cleanup(e){this._renderer.setRenderTarget(zf,Gf,Hf),this._renderer.xr.enabled=Wf,e.scissorTest=!1,Jo(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===cr||e.mapping===Wr?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),zf=this._renderer.getRenderTarget(),Gf=this._renderer.getActiveCubeFace(),Hf=this._renderer.getActiveMipmapLevel(),Wf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let i=t||this._allocateTargets();return this._textureToCubeUV(e,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){let e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,i={magFilter:Tn,minFilter:Tn,generateMipmaps:!1,type:fs,format:ri,colorSpace:Ua,depthBuffer:!1},s=__(e,t,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=__(e,t,i);let{_lodMax:r}=this;({lodMeshes:this._lodMeshes,sizeLods:this._sizeLods,sigmas:this._sigmas}=tT(r)),this._blurMaterial=iT(r,e,t),this._ggxMaterial=nT(r,e,t)}return s}_compileMaterial(e){let t=new Ft(new vn,e);this._renderer.compile(t,hl)}_sceneToCubeUV(e,t,i,s,r){let l=new Wn(90,1,t,i),c=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],d=this._renderer,h=d.autoClear,f=d.toneMapping;d.getClearColor(g_),d.toneMapping=Qi,d.autoClear=!1,d.state.buffers.depth.getReversed()&&(d.setRenderTarget(s),d.clearDepth(),d.setRenderTarget(null)),this._backgroundBox===null&&(this._backgroundBox=new Ft(new hs,new Xa({name:"PMREM.Background",side:si,depthWrite:!1,depthTest:!1})));let v=this._backgroundBox,g=v.material,m=!1,S=e.background;S?S.isColor&&(g.color.copy(S),e.background=null,m=!0):(g.color.copy(g_),m=!0);for(let A=0;A<6;A++){let b=A%3;b===0?(l.up.set(0,c[A],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+u[A],r.y,r.z)):b===1?(l.up.set(0,0,c[A]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+u[A],r.z)):(l.up.set(0,c[A],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+u[A]));let C=this._cubeSize;Jo(s,b*C,A>2?C:0,C,C),d.setRenderTarget(s),m&&d.render(v,l),d.render(e,l)}d.toneMapping=f,d.autoClear=h,e.background=S}_textureToCubeUV(e,t){let i=this._renderer,s=e.mapping===cr||e.mapping===Wr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=y_()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=x_());let r=s?this._cubemapMaterial:this._equirectMaterial,o=this._lodMeshes[0];o.material=r;let a=r.uniforms;a.envMap.value=e;let l=this._cubeSize;Jo(t,0,0,3*l,2*l),i.setRenderTarget(t),i.render(o,hl)}_applyPMREM(e){let t=this._renderer,i=t.autoClear;t.autoClear=!1;let s=this._lodMeshes.length;for(let r=1;r<s;r++)this._applyGGXFilter(e,r-1,r);t.autoClear=i}_applyGGXFilter(e,t,i){let s=this._renderer,r=this._pingPongRenderTarget,o=this._ggxMaterial,a=this._lodMeshes[i];a.material=o;let l=o.uniforms,c=i/(this._lodMeshes.length-1),u=t/(this._lodMeshes.length-1),d=Math.sqrt(c*c-u*u),h=0+c*1.25,f=d*h,{_lodMax:p}=this,v=this._sizeLods[i],g=3*v*(i>p-fr?i-p+fr:0),m=4*(this._cubeSize-v);l.envMap.value=e.texture,l.roughness.value=f,l.mipInt.value=p-t,Jo(r,g,m,3*v,2*v),s.setRenderTarget(r),s.render(a,hl),l.envMap.value=r.texture,l.roughness.value=0,l.mipInt.value=p-i,Jo(e,g,m,3*v,2*v),s.setRenderTarget(e),s.render(a,hl)}_blur(e,t,i,s,r){let o=this._pingPongRenderTarget;this._halfBlur(e,o,t,i,s,"latitudinal",r),this._halfBlur(o,e,i,i,s,"longitudinal",r)}_halfBlur(e,t,i,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&Ke("blur direction must be either latitudinal or longitudinal!");let u=3,d=this._lodMeshes[s];d.material=c;let h=c.uniforms,f=this._sizeLods[i]-1,p=isFinite(r)?Math.PI/(2*f):2*Math.PI/(2*qr-1),v=r/p,g=isFinite(r)?1+Math.floor(u*v):qr;g>qr&&$e(`sigmaRadians, ${r}, is too large and will clip, as it requested ${g} samples when the maximum is set to ${qr}`);let m=[],S=0;for(let N=0;N<qr;++N){let y=N/v,E=Math.exp(-y*y/2);m.push(E),N===0?S+=E:N<g&&(S+=2*E)}for(let N=0;N<m.length;N++)m[N]=m[N]/S;h.envMap.value=e.texture,h.samples.value=g,h.weights.value=m,h.latitudinal.value=o==="latitudinal",a&&(h.poleAxis.value=a);let{_lodMax:A}=this;h.dTheta.value=p,h.mipInt.value=A-i;let b=this._sizeLods[s],C=3*b*(s>A-fr?s-A+fr:0),T=4*(this._cubeSize-b);Jo(t,C,T,3*b,2*b),l.setRenderTarget(t),l.render(d,hl)}};function tT(n){let e=[],t=[],i=[],s=n,r=n-fr+1+m_.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);e.push(a);let l=1/a;o>n-fr?l=m_[o-n+fr-1]:o===0&&(l=0),t.push(l);let c=1/(a-2),u=-c,d=1+c,h=[u,u,d,u,d,d,u,u,d,d,u,d],f=6,p=6,v=3,g=2,m=1,S=new Float32Array(v*p*f),A=new Float32Array(g*p*f),b=new Float32Array(m*p*f);for(let T=0;T<f;T++){let N=T%3*2/3-1,y=T>2?0:-1,E=[N,y,0,N+2/3,y,0,N+2/3,y+1,0,N,y,0,N+2/3,y+1,0,N,y+1,0];S.set(E,v*p*T),A.set(h,g*p*T);let F=[T,T,T,T,T,T];b.set(F,m*p*T)}let C=new vn;C.setAttribute("position",new li(S,v)),C.setAttribute("uv",new li(A,g)),C.setAttribute("faceIndex",new li(b,m)),i.push(new Ft(C,null)),s>fr&&s--}return{lodMeshes:i,sizeLods:e,sigmas:t}}function __(n,e,t){let i=new Ti(n,e,t);return i.texture.mapping=il,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function Jo(n,e,t,i,s){n.viewport.set(e,t,i,s),n.scissor.set(e,t,i,s)}function nT(n,e,t){return new ln({name:"PMREMGGXConvolution",defines:{GGX_SAMPLES:Q1,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},roughness:{value:0},mipInt:{value:0}},vertexShader:uh(),fragmentShader:`

			precision highp float;
			precision highp int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform float roughness;
			uniform float mipInt;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			#define PI 3.14159265359

			// Van der Corput radical inverse
			float radicalInverse_VdC(uint bits) {
				bits = (bits << 16u) | (bits >> 16u);
				bits = ((bits & 0x55555555u) << 1u) | ((bits & 0xAAAAAAAAu) >> 1u);
				bits = ((bits & 0x33333333u) << 2u) | ((bits & 0xCCCCCCCCu) >> 2u);
				bits = ((bits & 0x0F0F0F0Fu) << 4u) | ((bits & 0xF0F0F0F0u) >> 4u);
				bits = ((bits & 0x00FF00FFu) << 8u) | ((bits & 0xFF00FF00u) >> 8u);
				return float(bits) * 2.3283064365386963e-10; // / 0x100000000
			}

			// Hammersley sequence
			vec2 hammersley(uint i, uint N) {
				return vec2(float(i) / float(N), radicalInverse_VdC(i));
			}

			// GGX VNDF importance sampling (Eric Heitz 2018)
			// "Sampling the GGX Distribution of Visible Normals"
			// https://jcgt.org/published/0007/04/01/
			vec3 importanceSampleGGX_VNDF(vec2 Xi, vec3 V, float roughness) {
				float alpha = roughness * roughness;

				// Section 4.1: Orthonormal basis
				vec3 T1 = vec3(1.0, 0.0, 0.0);
				vec3 T2 = cross(V, T1);

				// Section 4.2: Parameterization of projected area
				float r = sqrt(Xi.x);
				float phi = 2.0 * PI * Xi.y;
				float t1 = r * cos(phi);
				float t2 = r * sin(phi);
				float s = 0.5 * (1.0 + V.z);
				t2 = (1.0 - s) * sqrt(1.0 - t1 * t1) + s * t2;

				// Section 4.3: Reprojection onto hemisphere
				vec3 Nh = t1 * T1 + t2 * T2 + sqrt(max(0.0, 1.0 - t1 * t1 - t2 * t2)) * V;

				// Section 3.4: Transform back to ellipsoid configuration
				return normalize(vec3(alpha * Nh.x, alpha * Nh.y, max(0.0, Nh.z)));
			}

			void main() {
				vec3 N = normalize(vOutputDirection);
				vec3 V = N; // Assume view direction equals normal for pre-filtering

				vec3 prefilteredColor = vec3(0.0);
				float totalWeight = 0.0;

				// For very low roughness, just sample the environment directly
				if (roughness < 0.001) {
					gl_FragColor = vec4(bilinearCubeUV(envMap, N, mipInt), 1.0);
					return;
				}

				// Tangent space basis for VNDF sampling
				vec3 up = abs(N.z) < 0.999 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
				vec3 tangent = normalize(cross(up, N));
				vec3 bitangent = cross(N, tangent);

				for(uint i = 0u; i < uint(GGX_SAMPLES); i++) {
					vec2 Xi = hammersley(i, uint(GGX_SAMPLES));

					// For PMREM, V = N, so in tangent space V is always (0, 0, 1)
					vec3 H_tangent = importanceSampleGGX_VNDF(Xi, vec3(0.0, 0.0, 1.0), roughness);

					// Transform H back to world space
					vec3 H = normalize(tangent * H_tangent.x + bitangent * H_tangent.y + N * H_tangent.z);
					vec3 L = normalize(2.0 * dot(V, H) * H - V);

					float NdotL = max(dot(N, L), 0.0);

					if(NdotL > 0.0) {
						// Sample environment at fixed mip level
						// VNDF importance sampling handles the distribution filtering
						vec3 sampleColor = bilinearCubeUV(envMap, L, mipInt);

						// Weight by NdotL for the split-sum approximation
						// VNDF PDF naturally accounts for the visible microfacet distribution
						prefilteredColor += sampleColor * NdotL;
						totalWeight += NdotL;
					}
				}

				if (totalWeight > 0.0) {
					prefilteredColor = prefilteredColor / totalWeight;
				}

				gl_FragColor = vec4(prefilteredColor, 1.0);
			}
		`,blending:ds,depthTest:!1,depthWrite:!1})}function iT(n,e,t){let i=new Float32Array(qr),s=new z(0,1,0);return new ln({name:"SphericalGaussianBlur",defines:{n:qr,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:uh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:ds,depthTest:!1,depthWrite:!1})}function x_(){return new ln({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:uh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:ds,depthTest:!1,depthWrite:!1})}function y_(){return new ln({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:uh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:ds,depthTest:!1,depthWrite:!1})}function uh(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}var lh=class extends Ti{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Ya(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new hs(5,5,5),r=new ln({name:"CubemapFromEquirect",uniforms:Xr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:si,blending:ds});r.uniforms.tEquirect.value=t;let o=new Ft(s,r),a=t.minFilter;return t.minFilter===ur&&(t.minFilter=Tn),new gu(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}};function sT(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,f=!1){return h==null?null:f?o(h):r(h)}function r(h){if(h&&h.isTexture){let f=h.mapping;if(f===xu||f===yu)if(e.has(h)){let p=e.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let v=new lh(p.height);return v.fromEquirectangularTexture(n,h),e.set(h,v),h.addEventListener("dispose",c),a(v.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture){let f=h.mapping,p=f===xu||f===yu,v=f===cr||f===Wr;if(p||v){let g=t.get(h),m=g!==void 0?g.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==m)return i===null&&(i=new ah(n)),g=p?i.fromEquirectangular(h,g):i.fromCubemap(h,g),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),g.texture;if(g!==void 0)return g.texture;{let S=h.image;return p&&S&&S.height>0||v&&S&&l(S)?(i===null&&(i=new ah(n)),g=p?i.fromEquirectangular(h):i.fromCubemap(h),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),h.addEventListener("dispose",u),g.texture):null}}}return h}function a(h,f){return f===xu?h.mapping=cr:f===yu&&(h.mapping=Wr),h}function l(h){let f=0,p=6;for(let v=0;v<p;v++)h[v]!==void 0&&f++;return f===p}function c(h){let f=h.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(h){let f=h.target;f.removeEventListener("dispose",u);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function d(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function rT(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&Or("WebGLRenderer: "+i+" extension not supported."),s}}}function oT(n,e,t,i){let s={},r=new WeakMap;function o(d){let h=d.target;h.index!==null&&e.remove(h.index);for(let p in h.attributes)e.remove(h.attributes[p]);h.removeEventListener("dispose",o),delete s[h.id];let f=r.get(h);f&&(e.remove(f),r.delete(h)),i.releaseStatesOfGeometry(h),h.isInstancedBufferGeometry===!0&&delete h._maxInstanceCount,t.memory.geometries--}function a(d,h){return s[h.id]===!0||(h.addEventListener("dispose",o),s[h.id]=!0,t.memory.geometries++),h}function l(d){let h=d.attributes;for(let f in h)e.update(h[f],n.ARRAY_BUFFER)}function c(d){let h=[],f=d.index,p=d.attributes.position,v=0;if(p===void 0)return;if(f!==null){let S=f.array;v=f.version;for(let A=0,b=S.length;A<b;A+=3){let C=S[A+0],T=S[A+1],N=S[A+2];h.push(C,T,T,N,N,C)}}else{let S=p.array;v=p.version;for(let A=0,b=S.length/3-1;A<b;A+=3){let C=A+0,T=A+1,N=A+2;h.push(C,T,T,N,N,C)}}let g=new(p.count>=65535?Wa:Ha)(h,1);g.version=v;let m=r.get(d);m&&e.remove(m),r.set(d,g)}function u(d){let h=r.get(d);if(h){let f=d.index;f!==null&&h.version<f.version&&c(d)}else c(d);return r.get(d)}return{get:a,update:l,getWireframeAttribute:u}}function aT(n,e,t){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,h){n.drawElements(i,h,r,d*o),t.update(h,i,1)}function c(d,h,f){f!==0&&(n.drawElementsInstanced(i,h,r,d*o,f),t.update(h,i,f))}function u(d,h,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,d,0,f);let v=0;for(let g=0;g<f;g++)v+=h[g];t.update(v,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function lT(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:Ke("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function cT(n,e,t){let i=new WeakMap,s=new Qt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==d){let E=function(){N.dispose(),i.delete(a),a.removeEventListener("dispose",E)};h!==void 0&&h.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],S=a.morphAttributes.color||[],A=0;f===!0&&(A=1),p===!0&&(A=2),v===!0&&(A=3);let b=a.attributes.position.count*A,C=1;b>e.maxTextureSize&&(C=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let T=new Float32Array(b*C*4*d),N=new Va(T,b,C,d);N.type=Ri,N.needsUpdate=!0;let y=A*4;for(let F=0;F<d;F++){let I=g[F],U=m[F],k=S[F],X=b*C*4*F;for(let O=0;O<I.count;O++){let $=O*y;f===!0&&(s.fromBufferAttribute(I,O),T[X+$+0]=s.x,T[X+$+1]=s.y,T[X+$+2]=s.z,T[X+$+3]=0),p===!0&&(s.fromBufferAttribute(U,O),T[X+$+4]=s.x,T[X+$+5]=s.y,T[X+$+6]=s.z,T[X+$+7]=0),v===!0&&(s.fromBufferAttribute(k,O),T[X+$+8]=s.x,T[X+$+9]=s.y,T[X+$+10]=s.z,T[X+$+11]=k.itemSize===4?s.w:1)}}h={count:d,texture:N,size:new Je(b,C)},i.set(a,h),a.addEventListener("dispose",E)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let v=0;v<c.length;v++)f+=c[v];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function uT(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,d=c.geometry,h=e.get(c,d);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var hT={[_f]:"LINEAR_TONE_MAPPING",[xf]:"REINHARD_TONE_MAPPING",[yf]:"CINEON_TONE_MAPPING",[vf]:"ACES_FILMIC_TONE_MAPPING",[Mf]:"AGX_TONE_MAPPING",[Sf]:"NEUTRAL_TONE_MAPPING",[bf]:"CUSTOM_TONE_MAPPING"};function dT(n,e,t,i,s,r){let o=new Ti(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,depthTexture:s?new Ps(e,t):void 0}),a=new Ti(e,t,{type:fs,depthBuffer:!1,stencilBuffer:!1}),l=new vn;l.setAttribute("position",new Dt([-1,3,0,-1,-1,0,3,-1,0],3)),l.setAttribute("uv",new Dt([0,2,0,0,2,0],2));let c=new iu({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new Ft(l,c),d=new Qa(-1,1,1,-1,0,1),h=null,f=null,p=!1,v,g=null,m=[],S=!1;this.setSize=function(A,b){o.setSize(A,b),a.setSize(A,b);for(let C=0;C<m.length;C++){let T=m[C];T.setSize&&T.setSize(A,b)}},this.setEffects=function(A){m=A,S=m.length>0&&m[0].isRenderPass===!0;let b=o.width,C=o.height;for(let T=0;T<m.length;T++){let N=m[T];N.setSize&&N.setSize(b,C)}},this.begin=function(A,b){if(p||A.toneMapping===Qi&&m.length===0)return!1;if(g=b,b!==null){let C=b.width,T=b.height;(o.width!==C||o.height!==T)&&this.setSize(C,T)}return S===!1&&A.setRenderTarget(o),v=A.toneMapping,A.toneMapping=Qi,!0},this.hasRenderPass=function(){return S},this.end=function(A,b){A.toneMapping=v,p=!0;let C=o,T=a;for(let N=0;N<m.length;N++){let y=m[N];if(y.enabled!==!1&&(y.render(A,T,C,b),y.needsSwap!==!1)){let E=C;C=T,T=E}}if(h!==A.outputColorSpace||f!==A.toneMapping){h=A.outputColorSpace,f=A.toneMapping,c.defines={},_t.getTransfer(h)===Nt&&(c.defines.SRGB_TRANSFER="");let N=hT[f];N&&(c.defines[N]=""),c.needsUpdate=!0}c.uniforms.tDiffuse.value=C.texture,A.setRenderTarget(g),A.render(u,d),g=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.depthTexture&&o.depthTexture.dispose(),o.dispose(),a.dispose(),l.dispose(),c.dispose()}}var B_=new ci,$f=new Ps(1,1),V_=new Va,z_=new Qc,G_=new Ya,v_=[],b_=[],M_=new Float32Array(16),S_=new Float32Array(9),w_=new Float32Array(4);function Qo(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=v_[s];if(r===void 0&&(r=new Float32Array(s),v_[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function En(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function An(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function hh(n,e){let t=b_[e];t===void 0&&(t=new Int32Array(e),b_[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function fT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function pT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(En(t,e))return;n.uniform2fv(this.addr,e),An(t,e)}}function mT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(En(t,e))return;n.uniform3fv(this.addr,e),An(t,e)}}function gT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(En(t,e))return;n.uniform4fv(this.addr,e),An(t,e)}}function _T(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(En(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),An(t,e)}else{if(En(t,i))return;w_.set(i),n.uniformMatrix2fv(this.addr,!1,w_),An(t,i)}}function xT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(En(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),An(t,e)}else{if(En(t,i))return;S_.set(i),n.uniformMatrix3fv(this.addr,!1,S_),An(t,i)}}function yT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(En(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),An(t,e)}else{if(En(t,i))return;M_.set(i),n.uniformMatrix4fv(this.addr,!1,M_),An(t,i)}}function vT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function bT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(En(t,e))return;n.uniform2iv(this.addr,e),An(t,e)}}function MT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(En(t,e))return;n.uniform3iv(this.addr,e),An(t,e)}}function ST(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(En(t,e))return;n.uniform4iv(this.addr,e),An(t,e)}}function wT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function TT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(En(t,e))return;n.uniform2uiv(this.addr,e),An(t,e)}}function ET(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(En(t,e))return;n.uniform3uiv(this.addr,e),An(t,e)}}function AT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(En(t,e))return;n.uniform4uiv(this.addr,e),An(t,e)}}function CT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?($f.compareFunction=t.isReversedDepthBuffer()?sh:ih,r=$f):r=B_,t.setTexture2D(e||r,s)}function RT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||z_,s)}function PT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTextureCube(e||G_,s)}function IT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||V_,s)}function LT(n){switch(n){case 5126:return fT;case 35664:return pT;case 35665:return mT;case 35666:return gT;case 35674:return _T;case 35675:return xT;case 35676:return yT;case 5124:case 35670:return vT;case 35667:case 35671:return bT;case 35668:case 35672:return MT;case 35669:case 35673:return ST;case 5125:return wT;case 36294:return TT;case 36295:return ET;case 36296:return AT;case 35678:case 36198:case 36298:case 36306:case 35682:return CT;case 35679:case 36299:case 36307:return RT;case 35680:case 36300:case 36308:case 36293:return PT;case 36289:case 36303:case 36311:case 36292:return IT}}function NT(n,e){n.uniform1fv(this.addr,e)}function DT(n,e){let t=Qo(e,this.size,2);n.uniform2fv(this.addr,t)}function FT(n,e){let t=Qo(e,this.size,3);n.uniform3fv(this.addr,t)}function UT(n,e){let t=Qo(e,this.size,4);n.uniform4fv(this.addr,t)}function OT(n,e){let t=Qo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function kT(n,e){let t=Qo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function BT(n,e){let t=Qo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function VT(n,e){n.uniform1iv(this.addr,e)}function zT(n,e){n.uniform2iv(this.addr,e)}function GT(n,e){n.uniform3iv(this.addr,e)}function HT(n,e){n.uniform4iv(this.addr,e)}function WT(n,e){n.uniform1uiv(this.addr,e)}function XT(n,e){n.uniform2uiv(this.addr,e)}function qT(n,e){n.uniform3uiv(this.addr,e)}function $T(n,e){n.uniform4uiv(this.addr,e)}function YT(n,e,t){let i=this.cache,s=e.length,r=hh(t,s);En(i,r)||(n.uniform1iv(this.addr,r),An(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=$f:o=B_;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function ZT(n,e,t){let i=this.cache,s=e.length,r=hh(t,s);En(i,r)||(n.uniform1iv(this.addr,r),An(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||z_,r[o])}function KT(n,e,t){let i=this.cache,s=e.length,r=hh(t,s);En(i,r)||(n.uniform1iv(this.addr,r),An(i,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||G_,r[o])}function JT(n,e,t){let i=this.cache,s=e.length,r=hh(t,s);En(i,r)||(n.uniform1iv(this.addr,r),An(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||V_,r[o])}function jT(n){switch(n){case 5126:return NT;case 35664:return DT;case 35665:return FT;case 35666:return UT;case 35674:return OT;case 35675:return kT;case 35676:return BT;case 5124:case 35670:return VT;case 35667:case 35671:return zT;case 35668:case 35672:return GT;case 35669:case 35673:return HT;case 5125:return WT;case 36294:return XT;case 36295:return qT;case 36296:return $T;case 35678:case 36198:case 36298:case 36306:case 35682:return YT;case 35679:case 36299:case 36307:return ZT;case 35680:case 36300:case 36308:case 36293:return KT;case 36289:case 36303:case 36311:case 36292:return JT}}var Yf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=LT(t.type)}},Zf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=jT(t.type)}},Kf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},Xf=/(\w+)(\])?(\[|\.)?/g;function T_(n,e){n.seq.push(e),n.map[e.id]=e}function QT(n,e,t){let i=n.name,s=i.length;for(Xf.lastIndex=0;;){let r=Xf.exec(i),o=Xf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){T_(t,c===void 0?new Yf(a,n,e):new Zf(a,n,e));break}else{let d=t.map[a];d===void 0&&(d=new Kf(a),T_(t,d)),t=d}}}var jo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);QT(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function E_(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var eE=37297,tE=0;function nE(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var A_=new it;function iE(n){_t._getMatrix(A_,_t.workingColorSpace,n);let e=`mat3( ${A_.elements.map(t=>t.toFixed(4))} )`;switch(_t.getTransfer(n)){case Oa:return[e,"LinearTransferOETF"];case Nt:return[e,"sRGBTransferOETF"];default:return $e("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function C_(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+nE(n.getShaderSource(e),a)}else return r}function sE(n,e){let t=iE(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}var rE={[_f]:"Linear",[xf]:"Reinhard",[yf]:"Cineon",[vf]:"ACESFilmic",[Mf]:"AgX",[Sf]:"Neutral",[bf]:"Custom"};function oE(n,e){let t=rE[e];return t===void 0?($e("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var oh=new z;function aE(){_t.getLuminanceCoefficients(oh);let n=oh.x.toFixed(4),e=oh.y.toFixed(4),t=oh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function lE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(fl).join(`
`)}function cE(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function uE(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function fl(n){return n!==""}function R_(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function P_(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var hE=/^[ \t]*#include +<([\w\d./]+)>/gm;function Jf(n){return n.replace(hE,fE)}var dE=new Map;function fE(n,e){let t=at[e];if(t===void 0){let i=dE.get(e);if(i!==void 0)t=at[i],$e('WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,i);else throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">")}return Jf(t)}var pE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function I_(n){return n.replace(pE,mE)}function mE(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function L_(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var gE={[nl]:"SHADOWMAP_TYPE_PCF",[$o]:"SHADOWMAP_TYPE_VSM"};function _E(n){return gE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var xE={[cr]:"ENVMAP_TYPE_CUBE",[Wr]:"ENVMAP_TYPE_CUBE",[il]:"ENVMAP_TYPE_CUBE_UV"};function yE(n){return n.envMap===!1?"ENVMAP_TYPE_CUBE":xE[n.envMapMode]||"ENVMAP_TYPE_CUBE"}var vE={[Wr]:"ENVMAP_MODE_REFRACTION"};function bE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":vE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var ME={[gf]:"ENVMAP_BLENDING_MULTIPLY",[J0]:"ENVMAP_BLENDING_MIX",[j0]:"ENVMAP_BLENDING_ADD"};function SE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":ME[n.combine]||"ENVMAP_BLENDING_NONE"}function wE(n){let e=n.envMapCubeUVHeight;if(e===null)return null;let t=Math.log2(e)-2,i=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:i,maxMip:t}}function TE(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=_E(t),c=yE(t),u=bE(t),d=SE(t),h=wE(t),f=lE(t),p=cE(r),v=s.createProgram(),g,m,S=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(fl).join(`
`),g.length>0&&(g+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(fl).join(`
`),m.length>0&&(m+=`
`)):(g=[L_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(fl).join(`
`),m=[L_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+d:"",h?"#define CUBEUV_TEXEL_WIDTH "+h.texelWidth:"",h?"#define CUBEUV_TEXEL_HEIGHT "+h.texelHeight:"",h?"#define CUBEUV_MAX_MIP "+h.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.numLightProbeGrids>0?"#define USE_LIGHT_PROBES_GRID":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Qi?"#define TONE_MAPPING":"",t.toneMapping!==Qi?at.tonemapping_pars_fragment:"",t.toneMapping!==Qi?oE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",at.colorspace_pars_fragment,sE("linearToOutputTexel",t.outputColorSpace),aE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(fl).join(`
`)),o=Jf(o),o=R_(o,t),o=P_(o,t),a=Jf(a),a=R_(a,t),a=P_(a,t),o=I_(o),a=I_(a),t.isRawShaderMaterial!==!0&&(S=`#version 300 es
`,g=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+g,m=["#define varying in",t.glslVersion===Nf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Nf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let A=S+g+o,b=S+m+a,C=E_(s,s.VERTEX_SHADER,A),T=E_(s,s.FRAGMENT_SHADER,b);s.attachShader(v,C),s.attachShader(v,T),t.index0AttributeName!==void 0?s.bindAttribLocation(v,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function N(I){if(n.debug.checkShaderErrors){let U=s.getProgramInfoLog(v)||"",k=s.getShaderInfoLog(C)||"",X=s.getShaderInfoLog(T)||"",O=U.trim(),$=k.trim(),H=X.trim(),ie=!0,oe=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(ie=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,v,C,T);else{let le=C_(s,C,"vertex"),de=C_(s,T,"fragment");Ke("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+O+`
`+le+`
`+de)}else O!==""?$e("WebGLProgram: Program Info Log:",O):($===""||H==="")&&(oe=!1);oe&&(I.diagnostics={runnable:ie,programLog:O,vertexShader:{log:$,prefix:g},fragmentShader:{log:H,prefix:m}})}s.deleteShader(C),s.deleteShader(T),y=new jo(s,v),E=uE(s,v)}let y;this.getUniforms=function(){return y===void 0&&N(this),y};let E;this.getAttributes=function(){return E===void 0&&N(this),E};let F=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return F===!1&&(F=s.getProgramParameter(v,eE)),F},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=tE++,this.cacheKey=e,this.usedTimes=1,this.program=v,this.vertexShader=C,this.fragmentShader=T,this}var EE=0,jf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Qf(e),t.set(e,i)),i}},Qf=class{constructor(e){this.id=EE++,this.code=e,this.usedTimes=0}};function AE(n){return n===dr||n===cl||n===ul}function CE(n,e,t,i,s,r){let o=new za,a=new jf,l=new Set,c=[],u=new Map,d=i.logarithmicDepthBuffer,h=i.precision,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(y){return l.add(y),y===0?"uv":`uv${y}`}function v(y,E,F,I,U,k){let X=I.fog,O=U.geometry,$=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?I.environment:null,H=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,ie=e.get(y.envMap||$,H),oe=ie&&ie.mapping===il?ie.image.height:null,le=f[y.type];y.precision!==null&&(h=i.getMaxPrecision(y.precision),h!==y.precision&&$e("WebGLProgram.getParameters:",y.precision,"not supported, using",h,"instead."));let de=O.morphAttributes.position||O.morphAttributes.normal||O.morphAttributes.color,ue=de!==void 0?de.length:0,_e=0;O.morphAttributes.position!==void 0&&(_e=1),O.morphAttributes.normal!==void 0&&(_e=2),O.morphAttributes.color!==void 0&&(_e=3);let st,et,Q,ae;if(le){let Ne=ms[le];st=Ne.vertexShader,et=Ne.fragmentShader}else{st=y.vertexShader,et=y.fragmentShader;let Ne=a.getVertexShaderStage(y),lt=a.getFragmentShaderStage(y);a.update(y,Ne,lt),Q=Ne.id,ae=lt.id}let he=n.getRenderTarget(),Ve=n.state.buffers.depth.getReversed(),De=U.isInstancedMesh===!0,ke=U.isBatchedMesh===!0,wt=!!y.map,Ye=!!y.matcap,pt=!!ie,ct=!!y.aoMap,ot=!!y.lightMap,qt=!!y.bumpMap&&y.wireframe===!1,en=!!y.normalMap,$t=!!y.displacementMap,bt=!!y.emissiveMap,Ut=!!y.metalnessMap,Pt=!!y.roughnessMap,G=y.anisotropy>0,We=y.clearcoat>0,fe=y.dispersion>0,R=y.iridescence>0,x=y.sheen>0,q=y.transmission>0,K=G&&!!y.anisotropyMap,ee=We&&!!y.clearcoatMap,me=We&&!!y.clearcoatNormalMap,ge=We&&!!y.clearcoatRoughnessMap,te=R&&!!y.iridescenceMap,ne=R&&!!y.iridescenceThicknessMap,xe=x&&!!y.sheenColorMap,Be=x&&!!y.sheenRoughnessMap,Me=!!y.specularMap,ve=!!y.specularColorMap,Oe=!!y.specularIntensityMap,Xe=q&&!!y.transmissionMap,qe=q&&!!y.thicknessMap,V=!!y.gradientMap,be=!!y.alphaMap,se=y.alphaTest>0,Se=!!y.alphaHash,Ae=!!y.extensions,ce=Qi;y.toneMapped&&(he===null||he.isXRRenderTarget===!0)&&(ce=n.toneMapping);let ze={shaderID:le,shaderType:y.type,shaderName:y.name,vertexShader:st,fragmentShader:et,defines:y.defines,customVertexShaderID:Q,customFragmentShaderID:ae,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:h,batching:ke,batchingColor:ke&&U._colorsTexture!==null,instancing:De,instancingColor:De&&U.instanceColor!==null,instancingMorph:De&&U.morphTexture!==null,outputColorSpace:he===null?n.outputColorSpace:he.isXRRenderTarget===!0?he.texture.colorSpace:_t.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:wt,matcap:Ye,envMap:pt,envMapMode:pt&&ie.mapping,envMapCubeUVHeight:oe,aoMap:ct,lightMap:ot,bumpMap:qt,normalMap:en,displacementMap:$t,emissiveMap:bt,normalMapObjectSpace:en&&y.normalMapType===t_,normalMapTangentSpace:en&&y.normalMapType===Lf,packedNormalMap:en&&y.normalMapType===Lf&&AE(y.normalMap.format),metalnessMap:Ut,roughnessMap:Pt,anisotropy:G,anisotropyMap:K,clearcoat:We,clearcoatMap:ee,clearcoatNormalMap:me,clearcoatRoughnessMap:ge,dispersion:fe,iridescence:R,iridescenceMap:te,iridescenceThicknessMap:ne,sheen:x,sheenColorMap:xe,sheenRoughnessMap:Be,specularMap:Me,specularColorMap:ve,specularIntensityMap:Oe,transmission:q,transmissionMap:Xe,thicknessMap:qe,gradientMap:V,opaque:y.transparent===!1&&y.blending===kr&&y.alphaToCoverage===!1,alphaMap:be,alphaTest:se,alphaHash:Se,combine:y.combine,mapUv:wt&&p(y.map.channel),aoMapUv:ct&&p(y.aoMap.channel),lightMapUv:ot&&p(y.lightMap.channel),bumpMapUv:qt&&p(y.bumpMap.channel),normalMapUv:en&&p(y.normalMap.channel),displacementMapUv:$t&&p(y.displacementMap.channel),emissiveMapUv:bt&&p(y.emissiveMap.channel),metalnessMapUv:Ut&&p(y.metalnessMap.channel),roughnessMapUv:Pt&&p(y.roughnessMap.channel),anisotropyMapUv:K&&p(y.anisotropyMap.channel),clearcoatMapUv:ee&&p(y.clearcoatMap.channel),clearcoatNormalMapUv:me&&p(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:ge&&p(y.clearcoatRoughnessMap.channel),iridescenceMapUv:te&&p(y.iridescenceMap.channel),iridescenceThicknessMapUv:ne&&p(y.iridescenceThicknessMap.channel),sheenColorMapUv:xe&&p(y.sheenColorMap.channel),sheenRoughnessMapUv:Be&&p(y.sheenRoughnessMap.channel),specularMapUv:Me&&p(y.specularMap.channel),specularColorMapUv:ve&&p(y.specularColorMap.channel),specularIntensityMapUv:Oe&&p(y.specularIntensityMap.channel),transmissionMapUv:Xe&&p(y.transmissionMap.channel),thicknessMapUv:qe&&p(y.thicknessMap.channel),alphaMapUv:be&&p(y.alphaMap.channel),vertexTangents:!!O.attributes.tangent&&(en||G),vertexNormals:!!O.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!O.attributes.color&&O.attributes.color.itemSize===4,pointsUvs:U.isPoints===!0&&!!O.attributes.uv&&(wt||be),fog:!!X,useFog:y.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||O.attributes.normal===void 0&&en===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:Ve,skinning:U.isSkinnedMesh===!0,hasPositionAttribute:O.attributes.position!==void 0,morphTargets:O.morphAttributes.position!==void 0,morphNormals:O.morphAttributes.normal!==void 0,morphColors:O.morphAttributes.color!==void 0,morphTargetsCount:ue,morphTextureStride:_e,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:k.length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&F.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:wt&&y.map.isVideoTexture===!0&&_t.getTransfer(y.map.colorSpace)===Nt,decodeVideoTextureEmissive:bt&&y.emissiveMap.isVideoTexture===!0&&_t.getTransfer(y.emissiveMap.colorSpace)===Nt,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===ui,flipSided:y.side===si,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Ae&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ae&&y.extensions.multiDraw===!0||ke)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return ze.vertexUv1s=l.has(1),ze.vertexUv2s=l.has(2),ze.vertexUv3s=l.has(3),l.clear(),ze}function g(y){let E=[];if(y.shaderID?E.push(y.shaderID):(E.push(y.customVertexShaderID),E.push(y.customFragmentShaderID)),y.defines!==void 0)for(let F in y.defines)E.push(F),E.push(y.defines[F]);return y.isRawShaderMaterial===!1&&(m(E,y),S(E,y),E.push(n.outputColorSpace)),E.push(y.customProgramCacheKey),E.join()}function m(y,E){y.push(E.precision),y.push(E.outputColorSpace),y.push(E.envMapMode),y.push(E.envMapCubeUVHeight),y.push(E.mapUv),y.push(E.alphaMapUv),y.push(E.lightMapUv),y.push(E.aoMapUv),y.push(E.bumpMapUv),y.push(E.normalMapUv),y.push(E.displacementMapUv),y.push(E.emissiveMapUv),y.push(E.metalnessMapUv),y.push(E.roughnessMapUv),y.push(E.anisotropyMapUv),y.push(E.clearcoatMapUv),y.push(E.clearcoatNormalMapUv),y.push(E.clearcoatRoughnessMapUv),y.push(E.iridescenceMapUv),y.push(E.iridescenceThicknessMapUv),y.push(E.sheenColorMapUv),y.push(E.sheenRoughnessMapUv),y.push(E.specularMapUv),y.push(E.specularColorMapUv),y.push(E.specularIntensityMapUv),y.push(E.transmissionMapUv),y.push(E.thicknessMapUv),y.push(E.combine),y.push(E.fogExp2),y.push(E.sizeAttenuation),y.push(E.morphTargetsCount),y.push(E.morphAttributeCount),y.push(E.numDirLights),y.push(E.numPointLights),y.push(E.numSpotLights),y.push(E.numSpotLightMaps),y.push(E.numHemiLights),y.push(E.numRectAreaLights),y.push(E.numDirLightShadows),y.push(E.numPointLightShadows),y.push(E.numSpotLightShadows),y.push(E.numSpotLightShadowsWithMaps),y.push(E.numLightProbes),y.push(E.shadowMapType),y.push(E.toneMapping),y.push(E.numClippingPlanes),y.push(E.numClipIntersection),y.push(E.depthPacking)}function S(y,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function A(y){let E=f[y.type],F;if(E){let I=ms[E];F=f_.clone(I.uniforms)}else F=y.uniforms;return F}function b(y,E){let F=u.get(E);return F!==void 0?++F.usedTimes:(F=new TE(n,E,y,s),c.push(F),u.set(E,F)),F}function C(y){if(--y.usedTimes===0){let E=c.indexOf(y);c[E]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function T(y){a.remove(y)}function N(){a.dispose()}return{getParameters:v,getProgramCacheKey:g,getUniforms:A,acquireProgram:b,releaseProgram:C,releaseShaderCache:T,programs:c,dispose:N}}function RE(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function PE(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function N_(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function D_(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let f=0;return h.isInstancedMesh&&(f+=2),h.isSkinnedMesh&&(f+=1),f}function a(h,f,p,v,g,m){let S=n[e];return S===void 0?(S={id:h.id,object:h,geometry:f,material:p,materialVariant:o(h),groupOrder:v,renderOrder:h.renderOrder,z:g,group:m},n[e]=S):(S.id=h.id,S.object=h,S.geometry=f,S.material=p,S.materialVariant=o(h),S.groupOrder=v,S.renderOrder=h.renderOrder,S.z=g,S.group=m),e++,S}function l(h,f,p,v,g,m){let S=a(h,f,p,v,g,m);p.transmission>0?i.push(S):p.transparent===!0?s.push(S):t.push(S)}function c(h,f,p,v,g,m){let S=a(h,f,p,v,g,m);p.transmission>0?i.unshift(S):p.transparent===!0?s.unshift(S):t.unshift(S)}function u(h,f,p){t.length>1&&t.sort(h||PE),i.length>1&&i.sort(f||N_),s.length>1&&s.sort(f||N_),p&&(t.reverse(),i.reverse(),s.reverse())}function d(){for(let h=e,f=n.length;h<f;h++){let p=n[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:d,sort:u}}function IE(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new D_,n.set(i,[o])):s>=r.length?(o=new D_,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function LE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new z,color:new xt};break;case"SpotLight":t={position:new z,direction:new z,color:new xt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new z,color:new xt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new z,skyColor:new xt,groundColor:new xt};break;case"RectAreaLight":t={color:new xt,position:new z,halfWidth:new z,halfHeight:new z};break}return n[e.id]=t,t}}}function NE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Je};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Je};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Je,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var DE=0;function FE(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function UE(n){let e=new LE,t=NE(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new z);let s=new z,r=new Gt,o=new Gt;function a(c){let u=0,d=0,h=0;for(let E=0;E<9;E++)i.probe[E].set(0,0,0);let f=0,p=0,v=0,g=0,m=0,S=0,A=0,b=0,C=0,T=0,N=0;c.sort(FE);for(let E=0,F=c.length;E<F;E++){let I=c[E],U=I.color,k=I.intensity,X=I.distance,O=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===dr?O=I.shadow.map.texture:O=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)u+=U.r*k,d+=U.g*k,h+=U.b*k;else if(I.isLightProbe){for(let $=0;$<9;$++)i.probe[$].addScaledVector(I.sh.coefficients[$],k);N++}else if(I.isDirectionalLight){let $=e.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let H=I.shadow,ie=t.get(I);ie.shadowIntensity=H.intensity,ie.shadowBias=H.bias,ie.shadowNormalBias=H.normalBias,ie.shadowRadius=H.radius,ie.shadowMapSize=H.mapSize,i.directionalShadow[f]=ie,i.directionalShadowMap[f]=O,i.directionalShadowMatrix[f]=I.shadow.matrix,S++}i.directional[f]=$,f++}else if(I.isSpotLight){let $=e.get(I);$.position.setFromMatrixPosition(I.matrixWorld),$.color.copy(U).multiplyScalar(k),$.distance=X,$.coneCos=Math.cos(I.angle),$.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),$.decay=I.decay,i.spot[v]=$;let H=I.shadow;if(I.map&&(i.spotLightMap[C]=I.map,C++,H.updateMatrices(I),I.castShadow&&T++),i.spotLightMatrix[v]=H.matrix,I.castShadow){let ie=t.get(I);ie.shadowIntensity=H.intensity,ie.shadowBias=H.bias,ie.shadowNormalBias=H.normalBias,ie.shadowRadius=H.radius,ie.shadowMapSize=H.mapSize,i.spotShadow[v]=ie,i.spotShadowMap[v]=O,b++}v++}else if(I.isRectAreaLight){let $=e.get(I);$.color.copy(U).multiplyScalar(k),$.halfWidth.set(I.width*.5,0,0),$.halfHeight.set(0,I.height*.5,0),i.rectArea[g]=$,g++}else if(I.isPointLight){let $=e.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),$.distance=I.distance,$.decay=I.decay,I.castShadow){let H=I.shadow,ie=t.get(I);ie.shadowIntensity=H.intensity,ie.shadowBias=H.bias,ie.shadowNormalBias=H.normalBias,ie.shadowRadius=H.radius,ie.shadowMapSize=H.mapSize,ie.shadowCameraNear=H.camera.near,ie.shadowCameraFar=H.camera.far,i.pointShadow[p]=ie,i.pointShadowMap[p]=O,i.pointShadowMatrix[p]=I.shadow.matrix,A++}i.point[p]=$,p++}else if(I.isHemisphereLight){let $=e.get(I);$.skyColor.copy(I.color).multiplyScalar(k),$.groundColor.copy(I.groundColor).multiplyScalar(k),i.hemi[m]=$,m++}}g>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ee.LTC_FLOAT_1,i.rectAreaLTC2=Ee.LTC_FLOAT_2):(i.rectAreaLTC1=Ee.LTC_HALF_1,i.rectAreaLTC2=Ee.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=d,i.ambient[2]=h;let y=i.hash;(y.directionalLength!==f||y.pointLength!==p||y.spotLength!==v||y.rectAreaLength!==g||y.hemiLength!==m||y.numDirectionalShadows!==S||y.numPointShadows!==A||y.numSpotShadows!==b||y.numSpotMaps!==C||y.numLightProbes!==N)&&(i.directional.length=f,i.spot.length=v,i.rectArea.length=g,i.point.length=p,i.hemi.length=m,i.directionalShadow.length=S,i.directionalShadowMap.length=S,i.pointShadow.length=A,i.pointShadowMap.length=A,i.spotShadow.length=b,i.spotShadowMap.length=b,i.directionalShadowMatrix.length=S,i.pointShadowMatrix.length=A,i.spotLightMatrix.length=b+C-T,i.spotLightMap.length=C,i.numSpotLightShadowsWithMaps=T,i.numLightProbes=N,y.directionalLength=f,y.pointLength=p,y.spotLength=v,y.rectAreaLength=g,y.hemiLength=m,y.numDirectionalShadows=S,y.numPointShadows=A,y.numSpotShadows=b,y.numSpotMaps=C,y.numLightProbes=N,i.version=DE++)}function l(c,u){let d=0,h=0,f=0,p=0,v=0,g=u.matrixWorldInverse;for(let m=0,S=c.length;m<S;m++){let A=c[m];if(A.isDirectionalLight){let b=i.directional[d];b.direction.setFromMatrixPosition(A.matrixWorld),s.setFromMatrixPosition(A.target.matrixWorld),b.direction.sub(s),b.direction.transformDirection(g),d++}else if(A.isSpotLight){let b=i.spot[f];b.position.setFromMatrixPosition(A.matrixWorld),b.position.applyMatrix4(g),b.direction.setFromMatrixPosition(A.matrixWorld),s.setFromMatrixPosition(A.target.matrixWorld),b.direction.sub(s),b.direction.transformDirection(g),f++}else if(A.isRectAreaLight){let b=i.rectArea[p];b.position.setFromMatrixPosition(A.matrixWorld),b.position.applyMatrix4(g),o.identity(),r.copy(A.matrixWorld),r.premultiply(g),o.extractRotation(r),b.halfWidth.set(A.width*.5,0,0),b.halfHeight.set(0,A.height*.5,0),b.halfWidth.applyMatrix4(o),b.halfHeight.applyMatrix4(o),p++}else if(A.isPointLight){let b=i.point[h];b.position.setFromMatrixPosition(A.matrixWorld),b.position.applyMatrix4(g),h++}else if(A.isHemisphereLight){let b=i.hemi[v];b.direction.setFromMatrixPosition(A.matrixWorld),b.direction.transformDirection(g),v++}}}return{setup:a,setupView:l,state:i}}function F_(n){let e=new UE(n),t=[],i=[],s=[];function r(h){d.camera=h,t.length=0,i.length=0,s.length=0}function o(h){t.push(h)}function a(h){i.push(h)}function l(h){s.push(h)}function c(){e.setup(t)}function u(h){e.setupView(t,h)}let d={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:d,setupLights:c,setupLightsView:u,pushLight:o,pushShadow:a,pushLightProbeGrid:l}}function OE(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new F_(n),e.set(s,[a])):r>=o.length?(a=new F_(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var kE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,BE=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,VE=[new z(1,0,0),new z(-1,0,0),new z(0,1,0),new z(0,-1,0),new z(0,0,1),new z(0,0,-1)],zE=[new z(0,-1,0),new z(0,-1,0),new z(0,0,1),new z(0,0,-1),new z(0,-1,0),new z(0,-1,0)],U_=new Gt,dl=new z,qf=new z;function GE(n,e,t){let i=new $a,s=new Je,r=new Je,o=new Qt,a=new su,l=new ru,c={},u=t.maxTextureSize,d={[Ji]:si,[si]:Ji,[ui]:ui},h=new ln({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Je},radius:{value:4}},vertexShader:kE,fragmentShader:BE}),f=h.clone();f.defines.HORIZONTAL_PASS=1;let p=new vn;p.setAttribute("position",new li(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Ft(p,h),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=nl;let m=this.type;this.render=function(T,N,y){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||T.length===0)return;this.type===L0&&($e("WebGLShadowMap: PCFSoftShadowMap has been deprecated. Using PCFShadowMap instead."),this.type=nl);let E=n.getRenderTarget(),F=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),U=n.state;U.setBlending(ds),U.buffers.depth.getReversed()===!0?U.buffers.color.setClear(0,0,0,0):U.buffers.color.setClear(1,1,1,1),U.buffers.depth.setTest(!0),U.setScissorTest(!1);let k=m!==this.type;k&&N.traverse(function(X){X.material&&(Array.isArray(X.material)?X.material.forEach(O=>O.needsUpdate=!0):X.material.needsUpdate=!0)});for(let X=0,O=T.length;X<O;X++){let $=T[X],H=$.shadow;if(H===void 0){$e("WebGLShadowMap:",$,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let ie=H.getFrameExtents();s.multiply(ie),r.copy(H.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ie.x),s.x=r.x*ie.x,H.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ie.y),s.y=r.y*ie.y,H.mapSize.y=r.y));let oe=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=oe,H.map===null||k===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===$o){if($.isPointLight){$e("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new Ti(s.x,s.y,{format:dr,type:fs,minFilter:Tn,magFilter:Tn,generateMipmaps:!1}),H.map.texture.name=$.name+".shadowMap",H.map.depthTexture=new Ps(s.x,s.y,Ri),H.map.depthTexture.name=$.name+".shadowMapDepth",H.map.depthTexture.format=us,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=yn,H.map.depthTexture.magFilter=yn}else $.isPointLight?(H.map=new lh(s.x),H.map.depthTexture=new nu(s.x,es)):(H.map=new Ti(s.x,s.y),H.map.depthTexture=new Ps(s.x,s.y,es)),H.map.depthTexture.name=$.name+".shadowMap",H.map.depthTexture.format=us,this.type===nl?(H.map.depthTexture.compareFunction=oe?sh:ih,H.map.depthTexture.minFilter=Tn,H.map.depthTexture.magFilter=Tn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=yn,H.map.depthTexture.magFilter=yn);H.camera.updateProjectionMatrix()}let le=H.map.isWebGLCubeRenderTarget?6:1;for(let de=0;de<le;de++){if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,de),n.clear();else{de===0&&(n.setRenderTarget(H.map),n.clear());let ue=H.getViewport(de);o.set(r.x*ue.x,r.y*ue.y,r.x*ue.z,r.y*ue.w),U.viewport(o)}if($.isPointLight){let ue=H.camera,_e=H.matrix,st=$.distance||ue.far;st!==ue.far&&(ue.far=st,ue.updateProjectionMatrix()),dl.setFromMatrixPosition($.matrixWorld),ue.position.copy(dl),qf.copy(ue.position),qf.add(VE[de]),ue.up.copy(zE[de]),ue.lookAt(qf),ue.updateMatrixWorld(),_e.makeTranslation(-dl.x,-dl.y,-dl.z),U_.multiplyMatrices(ue.projectionMatrix,ue.matrixWorldInverse),H._frustum.setFromProjectionMatrix(U_,ue.coordinateSystem,ue.reversedDepth)}else H.updateMatrices($);i=H.getFrustum(),b(N,y,H.camera,$,this.type)}H.isPointLightShadow!==!0&&this.type===$o&&S(H,y),H.needsUpdate=!1}m=this.type,g.needsUpdate=!1,n.setRenderTarget(E,F,I)};function S(T,N){let y=e.update(v);h.defines.VSM_SAMPLES!==T.blurSamples&&(h.defines.VSM_SAMPLES=T.blurSamples,f.defines.VSM_SAMPLES=T.blurSamples,h.needsUpdate=!0,f.needsUpdate=!0),T.mapPass===null&&(T.mapPass=new Ti(s.x,s.y,{format:dr,type:fs})),h.uniforms.shadow_pass.value=T.map.depthTexture,h.uniforms.resolution.value=T.mapSize,h.uniforms.radius.value=T.radius,n.setRenderTarget(T.mapPass),n.clear(),n.renderBufferDirect(N,null,y,h,v,null),f.uniforms.shadow_pass.value=T.mapPass.texture,f.uniforms.resolution.value=T.mapSize,f.uniforms.radius.value=T.radius,n.setRenderTarget(T.map),n.clear(),n.renderBufferDirect(N,null,y,f,v,null)}function A(T,N,y,E){let F=null,I=y.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(I!==void 0)F=I;else if(F=y.isPointLight===!0?l:a,n.localClippingEnabled&&N.clipShadows===!0&&Array.isArray(N.clippingPlanes)&&N.clippingPlanes.length!==0||N.displacementMap&&N.displacementScale!==0||N.alphaMap&&N.alphaTest>0||N.map&&N.alphaTest>0||N.alphaToCoverage===!0){let U=F.uuid,k=N.uuid,X=c[U];X===void 0&&(X={},c[U]=X);let O=X[k];O===void 0&&(O=F.clone(),X[k]=O,N.addEventListener("dispose",C)),F=O}if(F.visible=N.visible,F.wireframe=N.wireframe,E===$o?F.side=N.shadowSide!==null?N.shadowSide:N.side:F.side=N.shadowSide!==null?N.shadowSide:d[N.side],F.alphaMap=N.alphaMap,F.alphaTest=N.alphaToCoverage===!0?.5:N.alphaTest,F.map=N.map,F.clipShadows=N.clipShadows,F.clippingPlanes=N.clippingPlanes,F.clipIntersection=N.clipIntersection,F.displacementMap=N.displacementMap,F.displacementScale=N.displacementScale,F.displacementBias=N.displacementBias,F.wireframeLinewidth=N.wireframeLinewidth,F.linewidth=N.linewidth,y.isPointLight===!0&&F.isMeshDistanceMaterial===!0){let U=n.properties.get(F);U.light=y}return F}function b(T,N,y,E,F){if(T.visible===!1)return;if(T.layers.test(N.layers)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&F===$o)&&(!T.frustumCulled||i.intersectsObject(T))){T.modelViewMatrix.multiplyMatrices(y.matrixWorldInverse,T.matrixWorld);let k=e.update(T),X=T.material;if(Array.isArray(X)){let O=k.groups;for(let $=0,H=O.length;$<H;$++){let ie=O[$],oe=X[ie.materialIndex];if(oe&&oe.visible){let le=A(T,oe,E,F);T.onBeforeShadow(n,T,N,y,k,le,ie),n.renderBufferDirect(y,null,k,le,T,ie),T.onAfterShadow(n,T,N,y,k,le,ie)}}}else if(X.visible){let O=A(T,X,E,F);T.onBeforeShadow(n,T,N,y,k,O,null),n.renderBufferDirect(y,null,k,O,T,null),T.onAfterShadow(n,T,N,y,k,O,null)}}let U=T.children;for(let k=0,X=U.length;k<X;k++)b(U[k],N,y,E,F)}function C(T){T.target.removeEventListener("dispose",C);for(let y in c){let E=c[y],F=T.target.uuid;F in E&&(E[F].dispose(),delete E[F])}}}function HE(n,e){function t(){let V=!1,be=new Qt,se=null,Se=new Qt(0,0,0,0);return{setMask:function(Ae){se!==Ae&&!V&&(n.colorMask(Ae,Ae,Ae,Ae),se=Ae)},setLocked:function(Ae){V=Ae},setClear:function(Ae,ce,ze,Ne,lt){lt===!0&&(Ae*=Ne,ce*=Ne,ze*=Ne),be.set(Ae,ce,ze,Ne),Se.equals(be)===!1&&(n.clearColor(Ae,ce,ze,Ne),Se.copy(be))},reset:function(){V=!1,se=null,Se.set(-1,0,0,0)}}}function i(){let V=!1,be=!1,se=null,Se=null,Ae=null;return{setReversed:function(ce){if(be!==ce){let ze=e.get("EXT_clip_control");ce?ze.clipControlEXT(ze.LOWER_LEFT_EXT,ze.ZERO_TO_ONE_EXT):ze.clipControlEXT(ze.LOWER_LEFT_EXT,ze.NEGATIVE_ONE_TO_ONE_EXT),be=ce;let Ne=Ae;Ae=null,this.setClear(Ne)}},getReversed:function(){return be},setTest:function(ce){ce?he(n.DEPTH_TEST):Ve(n.DEPTH_TEST)},setMask:function(ce){se!==ce&&!V&&(n.depthMask(ce),se=ce)},setFunc:function(ce){if(be&&(ce=h_[ce]),Se!==ce){switch(ce){case zc:n.depthFunc(n.NEVER);break;case Gc:n.depthFunc(n.ALWAYS);break;case Hc:n.depthFunc(n.LESS);break;case Br:n.depthFunc(n.LEQUAL);break;case Wc:n.depthFunc(n.EQUAL);break;case Xc:n.depthFunc(n.GEQUAL);break;case qc:n.depthFunc(n.GREATER);break;case $c:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Se=ce}},setLocked:function(ce){V=ce},setClear:function(ce){Ae!==ce&&(Ae=ce,be&&(ce=1-ce),n.clearDepth(ce))},reset:function(){V=!1,se=null,Se=null,Ae=null,be=!1}}}function s(){let V=!1,be=null,se=null,Se=null,Ae=null,ce=null,ze=null,Ne=null,lt=null;return{setTest:function(ht){V||(ht?he(n.STENCIL_TEST):Ve(n.STENCIL_TEST))},setMask:function(ht){be!==ht&&!V&&(n.stencilMask(ht),be=ht)},setFunc:function(ht,Fn,Un){(se!==ht||Se!==Fn||Ae!==Un)&&(n.stencilFunc(ht,Fn,Un),se=ht,Se=Fn,Ae=Un)},setOp:function(ht,Fn,Un){(ce!==ht||ze!==Fn||Ne!==Un)&&(n.stencilOp(ht,Fn,Un),ce=ht,ze=Fn,Ne=Un)},setLocked:function(ht){V=ht},setClear:function(ht){lt!==ht&&(n.clearStencil(ht),lt=ht)},reset:function(){V=!1,be=null,se=null,Se=null,Ae=null,ce=null,ze=null,Ne=null,lt=null}}}let r=new t,o=new i,a=new s,l=new WeakMap,c=new WeakMap,u={},d={},h={},f=new WeakMap,p=[],v=null,g=!1,m=null,S=null,A=null,b=null,C=null,T=null,N=null,y=new xt(0,0,0),E=0,F=!1,I=null,U=null,k=null,X=null,O=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,ie=0,oe=n.getParameter(n.VERSION);oe.indexOf("WebGL")!==-1?(ie=parseFloat(/^WebGL (\d)/.exec(oe)[1]),H=ie>=1):oe.indexOf("OpenGL ES")!==-1&&(ie=parseFloat(/^OpenGL ES (\d)/.exec(oe)[1]),H=ie>=2);let le=null,de={},ue=n.getParameter(n.SCISSOR_BOX),_e=n.getParameter(n.VIEWPORT),st=new Qt().fromArray(ue),et=new Qt().fromArray(_e);function Q(V,be,se,Se){let Ae=new Uint8Array(4),ce=n.createTexture();n.bindTexture(V,ce),n.texParameteri(V,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(V,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let ze=0;ze<se;ze++)V===n.TEXTURE_3D||V===n.TEXTURE_2D_ARRAY?n.texImage3D(be,0,n.RGBA,1,1,Se,0,n.RGBA,n.UNSIGNED_BYTE,Ae):n.texImage2D(be+ze,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Ae);return ce}let ae={};ae[n.TEXTURE_2D]=Q(n.TEXTURE_2D,n.TEXTURE_2D,1),ae[n.TEXTURE_CUBE_MAP]=Q(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),ae[n.TEXTURE_2D_ARRAY]=Q(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),ae[n.TEXTURE_3D]=Q(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),he(n.DEPTH_TEST),o.setFunc(Br),qt(!1),en(df),he(n.CULL_FACE),ct(ds);function he(V){u[V]!==!0&&(n.enable(V),u[V]=!0)}function Ve(V){u[V]!==!1&&(n.disable(V),u[V]=!1)}function De(V,be){return h[V]!==be?(n.bindFramebuffer(V,be),h[V]=be,V===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=be),V===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=be),!0):!1}function ke(V,be){let se=p,Se=!1;if(V){se=f.get(be),se===void 0&&(se=[],f.set(be,se));let Ae=V.textures;if(se.length!==Ae.length||se[0]!==n.COLOR_ATTACHMENT0){for(let ce=0,ze=Ae.length;ce<ze;ce++)se[ce]=n.COLOR_ATTACHMENT0+ce;se.length=Ae.length,Se=!0}}else se[0]!==n.BACK&&(se[0]=n.BACK,Se=!0);Se&&n.drawBuffers(se)}function wt(V){return v!==V?(n.useProgram(V),v=V,!0):!1}let Ye={[er]:n.FUNC_ADD,[D0]:n.FUNC_SUBTRACT,[F0]:n.FUNC_REVERSE_SUBTRACT};Ye[U0]=n.MIN,Ye[O0]=n.MAX;let pt={[k0]:n.ZERO,[B0]:n.ONE,[V0]:n.SRC_COLOR,[Bc]:n.SRC_ALPHA,[q0]:n.SRC_ALPHA_SATURATE,[W0]:n.DST_COLOR,[G0]:n.DST_ALPHA,[z0]:n.ONE_MINUS_SRC_COLOR,[Vc]:n.ONE_MINUS_SRC_ALPHA,[X0]:n.ONE_MINUS_DST_COLOR,[H0]:n.ONE_MINUS_DST_ALPHA,[$0]:n.CONSTANT_COLOR,[Y0]:n.ONE_MINUS_CONSTANT_COLOR,[Z0]:n.CONSTANT_ALPHA,[K0]:n.ONE_MINUS_CONSTANT_ALPHA};function ct(V,be,se,Se,Ae,ce,ze,Ne,lt,ht){if(V===ds){g===!0&&(Ve(n.BLEND),g=!1);return}if(g===!1&&(he(n.BLEND),g=!0),V!==N0){if(V!==m||ht!==F){if((S!==er||C!==er)&&(n.blendEquation(n.FUNC_ADD),S=er,C=er),ht)switch(V){case kr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case ff:n.blendFunc(n.ONE,n.ONE);break;case pf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case mf:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Ke("WebGLState: Invalid blending: ",V);break}else switch(V){case kr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case ff:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case pf:Ke("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case mf:Ke("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ke("WebGLState: Invalid blending: ",V);break}A=null,b=null,T=null,N=null,y.set(0,0,0),E=0,m=V,F=ht}return}Ae=Ae||be,ce=ce||se,ze=ze||Se,(be!==S||Ae!==C)&&(n.blendEquationSeparate(Ye[be],Ye[Ae]),S=be,C=Ae),(se!==A||Se!==b||ce!==T||ze!==N)&&(n.blendFuncSeparate(pt[se],pt[Se],pt[ce],pt[ze]),A=se,b=Se,T=ce,N=ze),(Ne.equals(y)===!1||lt!==E)&&(n.blendColor(Ne.r,Ne.g,Ne.b,lt),y.copy(Ne),E=lt),m=V,F=!1}function ot(V,be){V.side===ui?Ve(n.CULL_FACE):he(n.CULL_FACE);let se=V.side===si;be&&(se=!se),qt(se),V.blending===kr&&V.transparent===!1?ct(ds):ct(V.blending,V.blendEquation,V.blendSrc,V.blendDst,V.blendEquationAlpha,V.blendSrcAlpha,V.blendDstAlpha,V.blendColor,V.blendAlpha,V.premultipliedAlpha),o.setFunc(V.depthFunc),o.setTest(V.depthTest),o.setMask(V.depthWrite),r.setMask(V.colorWrite);let Se=V.stencilWrite;a.setTest(Se),Se&&(a.setMask(V.stencilWriteMask),a.setFunc(V.stencilFunc,V.stencilRef,V.stencilFuncMask),a.setOp(V.stencilFail,V.stencilZFail,V.stencilZPass)),bt(V.polygonOffset,V.polygonOffsetFactor,V.polygonOffsetUnits),V.alphaToCoverage===!0?he(n.SAMPLE_ALPHA_TO_COVERAGE):Ve(n.SAMPLE_ALPHA_TO_COVERAGE)}function qt(V){I!==V&&(V?n.frontFace(n.CW):n.frontFace(n.CCW),I=V)}function en(V){V!==P0?(he(n.CULL_FACE),V!==U&&(V===df?n.cullFace(n.BACK):V===I0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ve(n.CULL_FACE),U=V}function $t(V){V!==k&&(H&&n.lineWidth(V),k=V)}function bt(V,be,se){V?(he(n.POLYGON_OFFSET_FILL),(X!==be||O!==se)&&(X=be,O=se,o.getReversed()&&(be=-be),n.polygonOffset(be,se))):Ve(n.POLYGON_OFFSET_FILL)}function Ut(V){V?he(n.SCISSOR_TEST):Ve(n.SCISSOR_TEST)}function Pt(V){V===void 0&&(V=n.TEXTURE0+$-1),le!==V&&(n.activeTexture(V),le=V)}function G(V,be,se){se===void 0&&(le===null?se=n.TEXTURE0+$-1:se=le);let Se=de[se];Se===void 0&&(Se={type:void 0,texture:void 0},de[se]=Se),(Se.type!==V||Se.texture!==be)&&(le!==se&&(n.activeTexture(se),le=se),n.bindTexture(V,be||ae[V]),Se.type=V,Se.texture=be)}function We(){let V=de[le];V!==void 0&&V.type!==void 0&&(n.bindTexture(V.type,null),V.type=void 0,V.texture=void 0)}function fe(){try{n.compressedTexImage2D(...arguments)}catch(V){Ke("WebGLState:",V)}}function R(){try{n.compressedTexImage3D(...arguments)}catch(V){Ke("WebGLState:",V)}}function x(){try{n.texSubImage2D(...arguments)}catch(V){Ke("WebGLState:",V)}}function q(){try{n.texSubImage3D(...arguments)}catch(V){Ke("WebGLState:",V)}}function K(){try{n.compressedTexSubImage2D(...arguments)}catch(V){Ke("WebGLState:",V)}}function ee(){try{n.compressedTexSubImage3D(...arguments)}catch(V){Ke("WebGLState:",V)}}function me(){try{n.texStorage2D(...arguments)}catch(V){Ke("WebGLState:",V)}}function ge(){try{n.texStorage3D(...arguments)}catch(V){Ke("WebGLState:",V)}}function te(){try{n.texImage2D(...arguments)}catch(V){Ke("WebGLState:",V)}}function ne(){try{n.texImage3D(...arguments)}catch(V){Ke("WebGLState:",V)}}function xe(V){return d[V]!==void 0?d[V]:n.getParameter(V)}function Be(V,be){d[V]!==be&&(n.pixelStorei(V,be),d[V]=be)}function Me(V){st.equals(V)===!1&&(n.scissor(V.x,V.y,V.z,V.w),st.copy(V))}function ve(V){et.equals(V)===!1&&(n.viewport(V.x,V.y,V.z,V.w),et.copy(V))}function Oe(V,be){let se=c.get(be);se===void 0&&(se=new WeakMap,c.set(be,se));let Se=se.get(V);Se===void 0&&(Se=n.getUniformBlockIndex(be,V.name),se.set(V,Se))}function Xe(V,be){let Se=c.get(be).get(V);l.get(be)!==Se&&(n.uniformBlockBinding(be,Se,V.__bindingPointIndex),l.set(be,Se))}function qe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},d={},le=null,de={},h={},f=new WeakMap,p=[],v=null,g=!1,m=null,S=null,A=null,b=null,C=null,T=null,N=null,y=new xt(0,0,0),E=0,F=!1,I=null,U=null,k=null,X=null,O=null,st.set(0,0,n.canvas.width,n.canvas.height),et.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:he,disable:Ve,bindFramebuffer:De,drawBuffers:ke,useProgram:wt,setBlending:ct,setMaterial:ot,setFlipSided:qt,setCullFace:en,setLineWidth:$t,setPolygonOffset:bt,setScissorTest:Ut,activeTexture:Pt,bindTexture:G,unbindTexture:We,compressedTexImage2D:fe,compressedTexImage3D:R,texImage2D:te,texImage3D:ne,pixelStorei:Be,getParameter:xe,updateUBOMapping:Oe,uniformBlockBinding:Xe,texStorage2D:me,texStorage3D:ge,texSubImage2D:x,texSubImage3D:q,compressedTexSubImage2D:K,compressedTexSubImage3D:ee,scissor:Me,viewport:ve,reset:qe}}function WE(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Je,u=new WeakMap,d=new Set,h,f=new WeakMap,p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function v(R,x){return p?new OffscreenCanvas(R,x):Ba("canvas")}function g(R,x,q){let K=1,ee=fe(R);if((ee.width>q||ee.height>q)&&(K=q/Math.max(ee.width,ee.height)),K<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let me=Math.floor(K*ee.width),ge=Math.floor(K*ee.height);h===void 0&&(h=v(me,ge));let te=x?v(me,ge):h;return te.width=me,te.height=ge,te.getContext("2d").drawImage(R,0,0,me,ge),$e("WebGLRenderer: Texture has been resized from ("+ee.width+"x"+ee.height+") to ("+me+"x"+ge+")."),te}else return"data"in R&&$e("WebGLRenderer: Image in DataTexture is too big ("+ee.width+"x"+ee.height+")."),R;return R}function m(R){return R.generateMipmaps}function S(R){n.generateMipmap(R)}function A(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function b(R,x,q,K,ee,me=!1){if(R!==null){if(n[R]!==void 0)return n[R];$e("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ge;K&&(ge=e.get("EXT_texture_norm16"),ge||$e("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=x;if(x===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&ge&&(te=ge.R16_EXT),q===n.SHORT&&ge&&(te=ge.R16_SNORM_EXT)),x===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),x===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&ge&&(te=ge.RG16_EXT),q===n.SHORT&&ge&&(te=ge.RG16_SNORM_EXT)),x===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),x===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),x===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),x===n.RGB&&(q===n.UNSIGNED_SHORT&&ge&&(te=ge.RGB16_EXT),q===n.SHORT&&ge&&(te=ge.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),x===n.RGBA){let ne=me?Oa:_t.getTransfer(ee);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=ne===Nt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&ge&&(te=ge.RGBA16_EXT),q===n.SHORT&&ge&&(te=ge.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function C(R,x){let q;return R?x===null||x===es||x===Zo?q=n.DEPTH24_STENCIL8:x===Ri?q=n.DEPTH32F_STENCIL8:x===Yo&&(q=n.DEPTH24_STENCIL8,$e("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):x===null||x===es||x===Zo?q=n.DEPTH_COMPONENT24:x===Ri?q=n.DEPTH_COMPONENT32F:x===Yo&&(q=n.DEPTH_COMPONENT16),q}function T(R,x){return m(R)===!0||R.isFramebufferTexture&&R.minFilter!==yn&&R.minFilter!==Tn?Math.log2(Math.max(x.width,x.height))+1:R.mipmaps!==void 0&&R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?x.mipmaps.length:1}function N(R){let x=R.target;x.removeEventListener("dispose",N),E(x),x.isVideoTexture&&u.delete(x),x.isHTMLTexture&&d.delete(x)}function y(R){let x=R.target;x.removeEventListener("dispose",y),I(x)}function E(R){let x=i.get(R);if(x.__webglInit===void 0)return;let q=R.source,K=f.get(q);if(K){let ee=K[x.__cacheKey];ee.usedTimes--,ee.usedTimes===0&&F(R),Object.keys(K).length===0&&f.delete(q)}i.remove(R)}function F(R){let x=i.get(R);n.deleteTexture(x.__webglTexture);let q=R.source,K=f.get(q);delete K[x.__cacheKey],o.memory.textures--}function I(R){let x=i.get(R);if(R.depthTexture&&(R.depthTexture.dispose(),i.remove(R.depthTexture)),R.isWebGLCubeRenderTarget)for(let K=0;K<6;K++){if(Array.isArray(x.__webglFramebuffer[K]))for(let ee=0;ee<x.__webglFramebuffer[K].length;ee++)n.deleteFramebuffer(x.__webglFramebuffer[K][ee]);else n.deleteFramebuffer(x.__webglFramebuffer[K]);x.__webglDepthbuffer&&n.deleteRenderbuffer(x.__webglDepthbuffer[K])}else{if(Array.isArray(x.__webglFramebuffer))for(let K=0;K<x.__webglFramebuffer.length;K++)n.deleteFramebuffer(x.__webglFramebuffer[K]);else n.deleteFramebuffer(x.__webglFramebuffer);if(x.__webglDepthbuffer&&n.deleteRenderbuffer(x.__webglDepthbuffer),x.__webglMultisampledFramebuffer&&n.deleteFramebuffer(x.__webglMultisampledFramebuffer),x.__webglColorRenderbuffer)for(let K=0;K<x.__webglColorRenderbuffer.length;K++)x.__webglColorRenderbuffer[K]&&n.deleteRenderbuffer(x.__webglColorRenderbuffer[K]);x.__webglDepthRenderbuffer&&n.deleteRenderbuffer(x.__webglDepthRenderbuffer)}let q=R.textures;for(let K=0,ee=q.length;K<ee;K++){let me=i.get(q[K]);me.__webglTexture&&(n.deleteTexture(me.__webglTexture),o.memory.textures--),i.remove(q[K])}i.remove(R)}let U=0;function k(){U=0}function X(){return U}function O(R){U=R}function $(){let R=U;return R>=s.maxTextures&&$e("WebGLTextures: Trying to use "+R+" texture units while this GPU supports only "+s.maxTextures),U+=1,R}function H(R){let x=[];return x.push(R.wrapS),x.push(R.wrapT),x.push(R.wrapR||0),x.push(R.magFilter),x.push(R.minFilter),x.push(R.anisotropy),x.push(R.internalFormat),x.push(R.format),x.push(R.type),x.push(R.generateMipmaps),x.push(R.premultiplyAlpha),x.push(R.flipY),x.push(R.unpackAlignment),x.push(R.colorSpace),x.join()}function ie(R,x){let q=i.get(R);if(R.isVideoTexture&&G(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&q.__version!==R.version){let K=R.image;if(K===null)$e("WebGLRenderer: Texture marked for update but no image data found.");else if(K.complete===!1)$e("WebGLRenderer: Texture marked for update but image is incomplete");else{Ve(q,R,x);return}}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+x)}function oe(R,x){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Ve(q,R,x);return}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+x)}function le(R,x){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Ve(q,R,x);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+x)}function de(R,x){let q=i.get(R);if(R.isCubeDepthTexture!==!0&&R.version>0&&q.__version!==R.version){De(q,R,x);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+x)}let ue={[Yc]:n.REPEAT,[cs]:n.CLAMP_TO_EDGE,[Zc]:n.MIRRORED_REPEAT},_e={[yn]:n.NEAREST,[Q0]:n.NEAREST_MIPMAP_NEAREST,[sl]:n.NEAREST_MIPMAP_LINEAR,[Tn]:n.LINEAR,[vu]:n.LINEAR_MIPMAP_NEAREST,[ur]:n.LINEAR_MIPMAP_LINEAR},st={[n_]:n.NEVER,[a_]:n.ALWAYS,[i_]:n.LESS,[ih]:n.LEQUAL,[s_]:n.EQUAL,[sh]:n.GEQUAL,[r_]:n.GREATER,[o_]:n.NOTEQUAL};function et(R,x){if(x.type===Ri&&e.has("OES_texture_float_linear")===!1&&(x.magFilter===Tn||x.magFilter===vu||x.magFilter===sl||x.magFilter===ur||x.minFilter===Tn||x.minFilter===vu||x.minFilter===sl||x.minFilter===ur)&&$e("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,ue[x.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,ue[x.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,ue[x.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,_e[x.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,_e[x.minFilter]),x.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,st[x.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(x.magFilter===yn||x.minFilter!==sl&&x.minFilter!==ur||x.type===Ri&&e.has("OES_texture_float_linear")===!1)return;if(x.anisotropy>1||i.get(x).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(x.anisotropy,s.getMaxAnisotropy())),i.get(x).__currentAnisotropy=x.anisotropy}}}function Q(R,x){let q=!1;R.__webglInit===void 0&&(R.__webglInit=!0,x.addEventListener("dispose",N));let K=x.source,ee=f.get(K);ee===void 0&&(ee={},f.set(K,ee));let me=H(x);if(me!==R.__cacheKey){ee[me]===void 0&&(ee[me]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ee[me].usedTimes++;let ge=ee[R.__cacheKey];ge!==void 0&&(ee[R.__cacheKey].usedTimes--,ge.usedTimes===0&&F(x)),R.__cacheKey=me,R.__webglTexture=ee[me].texture}return q}function ae(R,x,q){return Math.floor(Math.floor(R/q)/x)}function he(R,x,q,K){let me=R.updateRanges;if(me.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,x.width,x.height,q,K,x.data);else{me.sort((Be,Me)=>Be.start-Me.start);let ge=0;for(let Be=1;Be<me.length;Be++){let Me=me[ge],ve=me[Be],Oe=Me.start+Me.count,Xe=ae(ve.start,x.width,4),qe=ae(Me.start,x.width,4);ve.start<=Oe+1&&Xe===qe&&ae(ve.start+ve.count-1,x.width,4)===Xe?Me.count=Math.max(Me.count,ve.start+ve.count-Me.start):(++ge,me[ge]=ve)}me.length=ge+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),ne=t.getParameter(n.UNPACK_SKIP_PIXELS),xe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,x.width);for(let Be=0,Me=me.length;Be<Me;Be++){let ve=me[Be],Oe=Math.floor(ve.start/4),Xe=Math.ceil(ve.count/4),qe=Oe%x.width,V=Math.floor(Oe/x.width),be=Xe,se=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,qe),t.pixelStorei(n.UNPACK_SKIP_ROWS,V),t.texSubImage2D(n.TEXTURE_2D,0,qe,V,be,se,q,K,x.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ne),t.pixelStorei(n.UNPACK_SKIP_ROWS,xe)}}function Ve(R,x,q){let K=n.TEXTURE_2D;(x.isDataArrayTexture||x.isCompressedArrayTexture)&&(K=n.TEXTURE_2D_ARRAY),x.isData3DTexture&&(K=n.TEXTURE_3D);let ee=Q(R,x),me=x.source;t.bindTexture(K,R.__webglTexture,n.TEXTURE0+q);let ge=i.get(me);if(me.version!==ge.__version||ee===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&x.image instanceof ImageBitmap)===!1){let se=_t.getPrimaries(_t.workingColorSpace),Se=x.colorSpace===Ls?null:_t.getPrimaries(x.colorSpace),Ae=x.colorSpace===Ls||se===Se?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,x.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ae)}t.pixelStorei(n.UNPACK_ALIGNMENT,x.unpackAlignment);let ne=g(x.image,!1,s.maxTextureSize);ne=We(x,ne);let xe=r.convert(x.format,x.colorSpace),Be=r.convert(x.type),Me=b(x.internalFormat,xe,Be,x.normalized,x.colorSpace,x.isVideoTexture);et(K,x);let ve,Oe=x.mipmaps,Xe=x.isVideoTexture!==!0,qe=ge.__version===void 0||ee===!0,V=me.dataReady,be=T(x,ne);if(x.isDepthTexture)Me=C(x.format===hr,x.type),qe&&(Xe?t.texStorage2D(n.TEXTURE_2D,1,Me,ne.width,ne.height):t.texImage2D(n.TEXTURE_2D,0,Me,ne.width,ne.height,0,xe,Be,null));else if(x.isDataTexture)if(Oe.length>0){Xe&&qe&&t.texStorage2D(n.TEXTURE_2D,be,Me,Oe[0].width,Oe[0].height);for(let se=0,Se=Oe.length;se<Se;se++)ve=Oe[se],Xe?V&&t.texSubImage2D(n.TEXTURE_2D,se,0,0,ve.width,ve.height,xe,Be,ve.data):t.texImage2D(n.TEXTURE_2D,se,Me,ve.width,ve.height,0,xe,Be,ve.data);x.generateMipmaps=!1}else Xe?(qe&&t.texStorage2D(n.TEXTURE_2D,be,Me,ne.width,ne.height),V&&he(x,ne,xe,Be)):t.texImage2D(n.TEXTURE_2D,0,Me,ne.width,ne.height,0,xe,Be,ne.data);else if(x.isCompressedTexture)if(x.isCompressedArrayTexture){Xe&&qe&&t.texStorage3D(n.TEXTURE_2D_ARRAY,be,Me,Oe[0].width,Oe[0].height,ne.depth);for(let se=0,Se=Oe.length;se<Se;se++)if(ve=Oe[se],x.format!==ri)if(xe!==null)if(Xe){if(V)if(x.layerUpdates.size>0){let Ae=Vf(ve.width,ve.height,x.format,x.type);for(let ce of x.layerUpdates){let ze=ve.data.subarray(ce*Ae/ve.data.BYTES_PER_ELEMENT,(ce+1)*Ae/ve.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,se,0,0,ce,ve.width,ve.height,1,xe,ze)}x.clearLayerUpdates()}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,se,0,0,0,ve.width,ve.height,ne.depth,xe,ve.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,se,Me,ve.width,ve.height,ne.depth,0,ve.data,0,0);else $e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Xe?V&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,se,0,0,0,ve.width,ve.height,ne.depth,xe,Be,ve.data):t.texImage3D(n.TEXTURE_2D_ARRAY,se,Me,ve.width,ve.height,ne.depth,0,xe,Be,ve.data)}else{Xe&&qe&&t.texStorage2D(n.TEXTURE_2D,be,Me,Oe[0].width,Oe[0].height);for(let se=0,Se=Oe.length;se<Se;se++)ve=Oe[se],x.format!==ri?xe!==null?Xe?V&&t.compressedTexSubImage2D(n.TEXTURE_2D,se,0,0,ve.width,ve.height,xe,ve.data):t.compressedTexImage2D(n.TEXTURE_2D,se,Me,ve.width,ve.height,0,ve.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Xe?V&&t.texSubImage2D(n.TEXTURE_2D,se,0,0,ve.width,ve.height,xe,Be,ve.data):t.texImage2D(n.TEXTURE_2D,se,Me,ve.width,ve.height,0,xe,Be,ve.data)}else if(x.isDataArrayTexture)if(Xe){if(qe&&t.texStorage3D(n.TEXTURE_2D_ARRAY,be,Me,ne.width,ne.height,ne.depth),V)if(x.layerUpdates.size>0){let se=Vf(ne.width,ne.height,x.format,x.type);for(let Se of x.layerUpdates){let Ae=ne.data.subarray(Se*se/ne.data.BYTES_PER_ELEMENT,(Se+1)*se/ne.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Se,ne.width,ne.height,1,xe,Be,Ae)}x.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ne.width,ne.height,ne.depth,xe,Be,ne.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,Me,ne.width,ne.height,ne.depth,0,xe,Be,ne.data);else if(x.isData3DTexture)Xe?(qe&&t.texStorage3D(n.TEXTURE_3D,be,Me,ne.width,ne.height,ne.depth),V&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ne.width,ne.height,ne.depth,xe,Be,ne.data)):t.texImage3D(n.TEXTURE_3D,0,Me,ne.width,ne.height,ne.depth,0,xe,Be,ne.data);else if(x.isFramebufferTexture){if(qe)if(Xe)t.texStorage2D(n.TEXTURE_2D,be,Me,ne.width,ne.height);else{let se=ne.width,Se=ne.height;for(let Ae=0;Ae<be;Ae++)t.texImage2D(n.TEXTURE_2D,Ae,Me,se,Se,0,xe,Be,null),se>>=1,Se>>=1}}else if(x.isHTMLTexture){if("texElementImage2D"in n){let se=n.canvas;if(se.hasAttribute("layoutsubtree")||se.setAttribute("layoutsubtree","true"),ne.parentNode!==se){se.appendChild(ne),d.add(x),se.onpaint=Se=>{let Ae=Se.changedElements;for(let ce of d)Ae.includes(ce.image)&&(ce.needsUpdate=!0)},se.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ne);else{let Ae=n.RGBA,ce=n.RGBA,ze=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Ae,ce,ze,ne)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Oe.length>0){if(Xe&&qe){let se=fe(Oe[0]);t.texStorage2D(n.TEXTURE_2D,be,Me,se.width,se.height)}for(let se=0,Se=Oe.length;se<Se;se++)ve=Oe[se],Xe?V&&t.texSubImage2D(n.TEXTURE_2D,se,0,0,xe,Be,ve):t.texImage2D(n.TEXTURE_2D,se,Me,xe,Be,ve);x.generateMipmaps=!1}else if(Xe){if(qe){let se=fe(ne);t.texStorage2D(n.TEXTURE_2D,be,Me,se.width,se.height)}V&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,xe,Be,ne)}else t.texImage2D(n.TEXTURE_2D,0,Me,xe,Be,ne);m(x)&&S(K),ge.__version=me.version,x.onUpdate&&x.onUpdate(x)}R.__version=x.version}function De(R,x,q){if(x.image.length!==6)return;let K=Q(R,x),ee=x.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+q);let me=i.get(ee);if(ee.version!==me.__version||K===!0){t.activeTexture(n.TEXTURE0+q);let ge=_t.getPrimaries(_t.workingColorSpace),te=x.colorSpace===Ls?null:_t.getPrimaries(x.colorSpace),ne=x.colorSpace===Ls||ge===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,x.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,x.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne);let xe=x.isCompressedTexture||x.image[0].isCompressedTexture,Be=x.image[0]&&x.image[0].isDataTexture,Me=[];for(let ce=0;ce<6;ce++)!xe&&!Be?Me[ce]=g(x.image[ce],!0,s.maxCubemapSize):Me[ce]=Be?x.image[ce].image:x.image[ce],Me[ce]=We(x,Me[ce]);let ve=Me[0],Oe=r.convert(x.format,x.colorSpace),Xe=r.convert(x.type),qe=b(x.internalFormat,Oe,Xe,x.normalized,x.colorSpace),V=x.isVideoTexture!==!0,be=me.__version===void 0||K===!0,se=ee.dataReady,Se=T(x,ve);et(n.TEXTURE_CUBE_MAP,x);let Ae;if(xe){V&&be&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Se,qe,ve.width,ve.height);for(let ce=0;ce<6;ce++){Ae=Me[ce].mipmaps;for(let ze=0;ze<Ae.length;ze++){let Ne=Ae[ze];x.format!==ri?Oe!==null?V?se&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze,0,0,Ne.width,Ne.height,Oe,Ne.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze,qe,Ne.width,Ne.height,0,Ne.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):V?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze,0,0,Ne.width,Ne.height,Oe,Xe,Ne.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze,qe,Ne.width,Ne.height,0,Oe,Xe,Ne.data)}}}else{if(Ae=x.mipmaps,V&&be){Ae.length>0&&Se++;let ce=fe(Me[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Se,qe,ce.width,ce.height)}for(let ce=0;ce<6;ce++)if(Be){V?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,0,0,0,Me[ce].width,Me[ce].height,Oe,Xe,Me[ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,0,qe,Me[ce].width,Me[ce].height,0,Oe,Xe,Me[ce].data);for(let ze=0;ze<Ae.length;ze++){let lt=Ae[ze].image[ce].image;V?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze+1,0,0,lt.width,lt.height,Oe,Xe,lt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze+1,qe,lt.width,lt.height,0,Oe,Xe,lt.data)}}else{V?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,0,0,0,Oe,Xe,Me[ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,0,qe,Oe,Xe,Me[ce]);for(let ze=0;ze<Ae.length;ze++){let Ne=Ae[ze];V?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze+1,0,0,Oe,Xe,Ne.image[ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze+1,qe,Oe,Xe,Ne.image[ce])}}}m(x)&&S(n.TEXTURE_CUBE_MAP),me.__version=ee.version,x.onUpdate&&x.onUpdate(x)}R.__version=x.version}function ke(R,x,q,K,ee,me){let ge=r.convert(q.format,q.colorSpace),te=r.convert(q.type),ne=b(q.internalFormat,ge,te,q.normalized,q.colorSpace),xe=i.get(x),Be=i.get(q);if(Be.__renderTarget=x,!xe.__hasExternalTextures){let Me=Math.max(1,x.width>>me),ve=Math.max(1,x.height>>me);ee===n.TEXTURE_3D||ee===n.TEXTURE_2D_ARRAY?t.texImage3D(ee,me,ne,Me,ve,x.depth,0,ge,te,null):t.texImage2D(ee,me,ne,Me,ve,0,ge,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),Pt(x)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,K,ee,Be.__webglTexture,0,Ut(x)):(ee===n.TEXTURE_2D||ee>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ee<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,K,ee,Be.__webglTexture,me),t.bindFramebuffer(n.FRAMEBUFFER,null)}function wt(R,x,q){if(n.bindRenderbuffer(n.RENDERBUFFER,R),x.depthBuffer){let K=x.depthTexture,ee=K&&K.isDepthTexture?K.type:null,me=C(x.stencilBuffer,ee),ge=x.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Pt(x)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Ut(x),me,x.width,x.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,Ut(x),me,x.width,x.height):n.renderbufferStorage(n.RENDERBUFFER,me,x.width,x.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ge,n.RENDERBUFFER,R)}else{let K=x.textures;for(let ee=0;ee<K.length;ee++){let me=K[ee],ge=r.convert(me.format,me.colorSpace),te=r.convert(me.type),ne=b(me.internalFormat,ge,te,me.normalized,me.colorSpace);Pt(x)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Ut(x),ne,x.width,x.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,Ut(x),ne,x.width,x.height):n.renderbufferStorage(n.RENDERBUFFER,ne,x.width,x.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Ye(R,x,q){let K=x.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(x.depthTexture&&x.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ee=i.get(x.depthTexture);if(ee.__renderTarget=x,(!ee.__webglTexture||x.depthTexture.image.width!==x.width||x.depthTexture.image.height!==x.height)&&(x.depthTexture.image.width=x.width,x.depthTexture.image.height=x.height,x.depthTexture.needsUpdate=!0),K){if(ee.__webglInit===void 0&&(ee.__webglInit=!0,x.depthTexture.addEventListener("dispose",N)),ee.__webglTexture===void 0){ee.__webglTexture=n.createTexture(),t.bindTexture(n.TEXTURE_CUBE_MAP,ee.__webglTexture),et(n.TEXTURE_CUBE_MAP,x.depthTexture);let xe=r.convert(x.depthTexture.format),Be=r.convert(x.depthTexture.type),Me;x.depthTexture.format===us?Me=n.DEPTH_COMPONENT24:x.depthTexture.format===hr&&(Me=n.DEPTH24_STENCIL8);for(let ve=0;ve<6;ve++)n.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ve,0,Me,x.width,x.height,0,xe,Be,null)}}else ie(x.depthTexture,0);let me=ee.__webglTexture,ge=Ut(x),te=K?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,ne=x.depthTexture.format===hr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(x.depthTexture.format===us)Pt(x)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ne,te,me,0,ge):n.framebufferTexture2D(n.FRAMEBUFFER,ne,te,me,0);else if(x.depthTexture.format===hr)Pt(x)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ne,te,me,0,ge):n.framebufferTexture2D(n.FRAMEBUFFER,ne,te,me,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function pt(R){let x=i.get(R),q=R.isWebGLCubeRenderTarget===!0;if(x.__boundDepthTexture!==R.depthTexture){let K=R.depthTexture;if(x.__depthDisposeCallback&&x.__depthDisposeCallback(),K){let ee=()=>{delete x.__boundDepthTexture,delete x.__depthDisposeCallback,K.removeEventListener("dispose",ee)};K.addEventListener("dispose",ee),x.__depthDisposeCallback=ee}x.__boundDepthTexture=K}if(R.depthTexture&&!x.__autoAllocateDepthBuffer)if(q)for(let K=0;K<6;K++)Ye(x.__webglFramebuffer[K],R,K);else{let K=R.texture.mipmaps;K&&K.length>0?Ye(x.__webglFramebuffer[0],R,0):Ye(x.__webglFramebuffer,R,0)}else if(q){x.__webglDepthbuffer=[];for(let K=0;K<6;K++)if(t.bindFramebuffer(n.FRAMEBUFFER,x.__webglFramebuffer[K]),x.__webglDepthbuffer[K]===void 0)x.__webglDepthbuffer[K]=n.createRenderbuffer(),wt(x.__webglDepthbuffer[K],R,!1);else{let ee=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,me=x.__webglDepthbuffer[K];n.bindRenderbuffer(n.RENDERBUFFER,me),n.framebufferRenderbuffer(n.FRAMEBUFFER,ee,n.RENDERBUFFER,me)}}else{let K=R.texture.mipmaps;if(K&&K.length>0?t.bindFramebuffer(n.FRAMEBUFFER,x.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,x.__webglFramebuffer),x.__webglDepthbuffer===void 0)x.__webglDepthbuffer=n.createRenderbuffer(),wt(x.__webglDepthbuffer,R,!1);else{let ee=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,me=x.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,me),n.framebufferRenderbuffer(n.FRAMEBUFFER,ee,n.RENDERBUFFER,me)}}t.bindFramebuffer(n.FRAMEBUFFER,null)}function ct(R,x,q){let K=i.get(R);x!==void 0&&ke(K.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&pt(R)}function ot(R){let x=R.texture,q=i.get(R),K=i.get(x);R.addEventListener("dispose",y);let ee=R.textures,me=R.isWebGLCubeRenderTarget===!0,ge=ee.length>1;if(ge||(K.__webglTexture===void 0&&(K.__webglTexture=n.createTexture()),K.__version=x.version,o.memory.textures++),me){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(x.mipmaps&&x.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let ne=0;ne<x.mipmaps.length;ne++)q.__webglFramebuffer[te][ne]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(x.mipmaps&&x.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<x.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(ge)for(let te=0,ne=ee.length;te<ne;te++){let xe=i.get(ee[te]);xe.__webglTexture===void 0&&(xe.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&Pt(R)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<ee.length;te++){let ne=ee[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let xe=r.convert(ne.format,ne.colorSpace),Be=r.convert(ne.type),Me=b(ne.internalFormat,xe,Be,ne.normalized,ne.colorSpace,R.isXRRenderTarget===!0),ve=Ut(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ve,Me,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),wt(q.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(me){t.bindTexture(n.TEXTURE_CUBE_MAP,K.__webglTexture),et(n.TEXTURE_CUBE_MAP,x);for(let te=0;te<6;te++)if(x.mipmaps&&x.mipmaps.length>0)for(let ne=0;ne<x.mipmaps.length;ne++)ke(q.__webglFramebuffer[te][ne],R,x,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,ne);else ke(q.__webglFramebuffer[te],R,x,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);m(x)&&S(n.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(ge){for(let te=0,ne=ee.length;te<ne;te++){let xe=ee[te],Be=i.get(xe),Me=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(Me=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(Me,Be.__webglTexture),et(Me,xe),ke(q.__webglFramebuffer,R,xe,n.COLOR_ATTACHMENT0+te,Me,0),m(xe)&&S(Me)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(te=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,K.__webglTexture),et(te,x),x.mipmaps&&x.mipmaps.length>0)for(let ne=0;ne<x.mipmaps.length;ne++)ke(q.__webglFramebuffer[ne],R,x,n.COLOR_ATTACHMENT0,te,ne);else ke(q.__webglFramebuffer,R,x,n.COLOR_ATTACHMENT0,te,0);m(x)&&S(te),t.unbindTexture()}R.depthBuffer&&pt(R)}function qt(R){let x=R.textures;for(let q=0,K=x.length;q<K;q++){let ee=x[q];if(m(ee)){let me=A(R),ge=i.get(ee).__webglTexture;t.bindTexture(me,ge),S(me),t.unbindTexture()}}}let en=[],$t=[];function bt(R){if(R.samples>0){if(Pt(R)===!1){let x=R.textures,q=R.width,K=R.height,ee=n.COLOR_BUFFER_BIT,me=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ge=i.get(R),te=x.length>1;if(te)for(let xe=0;xe<x.length;xe++)t.bindFramebuffer(n.FRAMEBUFFER,ge.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ge.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ge.__webglMultisampledFramebuffer);let ne=R.texture.mipmaps;ne&&ne.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ge.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ge.__webglFramebuffer);for(let xe=0;xe<x.length;xe++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(ee|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(ee|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ge.__webglColorRenderbuffer[xe]);let Be=i.get(x[xe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,Be,0)}n.blitFramebuffer(0,0,q,K,0,0,q,K,ee,n.NEAREST),l===!0&&(en.length=0,$t.length=0,en.push(n.COLOR_ATTACHMENT0+xe),R.depthBuffer&&R.resolveDepthBuffer===!1&&(en.push(me),$t.push(me),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,$t)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,en))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let xe=0;xe<x.length;xe++){t.bindFramebuffer(n.FRAMEBUFFER,ge.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.RENDERBUFFER,ge.__webglColorRenderbuffer[xe]);let Be=i.get(x[xe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ge.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.TEXTURE_2D,Be,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ge.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.resolveDepthBuffer===!1&&l){let x=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[x])}}}function Ut(R){return Math.min(s.maxSamples,R.samples)}function Pt(R){let x=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&x.__useRenderToTexture!==!1}function G(R){let x=o.render.frame;u.get(R)!==x&&(u.set(R,x),R.update())}function We(R,x){let q=R.colorSpace,K=R.format,ee=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||q!==Ua&&q!==Ls&&(_t.getTransfer(q)===Nt?(K!==ri||ee!==Ci)&&$e("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ke("WebGLTextures: Unsupported texture color space:",q)),x}function fe(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=$,this.resetTextureUnits=k,this.getTextureUnits=X,this.setTextureUnits=O,this.setTexture2D=ie,this.setTexture2DArray=oe,this.setTexture3D=le,this.setTextureCube=de,this.rebindTextures=ct,this.setupRenderTarget=ot,this.updateRenderTargetMipmap=qt,this.updateMultisampleRenderTarget=bt,this.setupDepthRenderbuffer=pt,this.setupFrameBufferTexture=ke,this.useMultisampledRTT=Pt,this.isReversedDepthBuffer=function(){return t.buffers.depth.getReversed()}}function XE(n,e){function t(i,s=Ls){let r,o=_t.getTransfer(s);if(i===Ci)return n.UNSIGNED_BYTE;if(i===Mu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Su)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Af)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Cf)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Tf)return n.BYTE;if(i===Ef)return n.SHORT;if(i===Yo)return n.UNSIGNED_SHORT;if(i===bu)return n.INT;if(i===es)return n.UNSIGNED_INT;if(i===Ri)return n.FLOAT;if(i===fs)return n.HALF_FLOAT;if(i===Rf)return n.ALPHA;if(i===Pf)return n.RGB;if(i===ri)return n.RGBA;if(i===us)return n.DEPTH_COMPONENT;if(i===hr)return n.DEPTH_STENCIL;if(i===If)return n.RED;if(i===wu)return n.RED_INTEGER;if(i===dr)return n.RG;if(i===Tu)return n.RG_INTEGER;if(i===Eu)return n.RGBA_INTEGER;if(i===rl||i===ol||i===al||i===ll)if(o===Nt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===rl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===ol)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===al)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===ll)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===rl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===ol)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===al)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===ll)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Au||i===Cu||i===Ru||i===Pu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Au)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Cu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Ru)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Pu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Iu||i===Lu||i===Nu||i===Du||i===Fu||i===cl||i===Uu)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Iu||i===Lu)return o===Nt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Nu)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Du)return r.COMPRESSED_R11_EAC;if(i===Fu)return r.COMPRESSED_SIGNED_R11_EAC;if(i===cl)return r.COMPRESSED_RG11_EAC;if(i===Uu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Ou||i===ku||i===Bu||i===Vu||i===zu||i===Gu||i===Hu||i===Wu||i===Xu||i===qu||i===$u||i===Yu||i===Zu||i===Ku)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Ou)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===ku)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Bu)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Vu)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===zu)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Gu)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Hu)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Wu)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Xu)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===qu)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===$u)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Yu)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Zu)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Ku)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Ju||i===ju||i===Qu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Ju)return o===Nt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===ju)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Qu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===eh||i===th||i===ul||i===nh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===eh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===th)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===ul)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===nh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Zo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var qE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,$E=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,ep=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Za(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new ln({vertexShader:qE,fragmentShader:$E,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Ft(new Hr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},tp=class extends ji{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,d=null,h=null,f=null,p=null,v=typeof XRWebGLBinding<"u",g=new ep,m={},S=t.getContextAttributes(),A=null,b=null,C=[],T=[],N=new Je,y=null,E=new Wn;E.viewport=new Qt;let F=new Wn;F.viewport=new Qt;let I=[E,F],U=new _u,k=null,X=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let ae=C[Q];return ae===void 0&&(ae=new Ho,C[Q]=ae),ae.getTargetRaySpace()},this.getControllerGrip=function(Q){let ae=C[Q];return ae===void 0&&(ae=new Ho,C[Q]=ae),ae.getGripSpace()},this.getHand=function(Q){let ae=C[Q];return ae===void 0&&(ae=new Ho,C[Q]=ae),ae.getHandSpace()};function O(Q){let ae=T.indexOf(Q.inputSource);if(ae===-1)return;let he=C[ae];he!==void 0&&(he.update(Q.inputSource,Q.frame,c||o),he.dispatchEvent({type:Q.type,data:Q.inputSource}))}function $(){s.removeEventListener("select",O),s.removeEventListener("selectstart",O),s.removeEventListener("selectend",O),s.removeEventListener("squeeze",O),s.removeEventListener("squeezestart",O),s.removeEventListener("squeezeend",O),s.removeEventListener("end",$),s.removeEventListener("inputsourceschange",H);for(let Q=0;Q<C.length;Q++){let ae=T[Q];ae!==null&&(T[Q]=null,C[Q].disconnect(ae))}k=null,X=null,g.reset();for(let Q in m)delete m[Q];e.setRenderTarget(A),f=null,h=null,d=null,s=null,b=null,et.stop(),i.isPresenting=!1,e.setPixelRatio(y),e.setSize(N.width,N.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,i.isPresenting===!0&&$e("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,i.isPresenting===!0&&$e("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return h!==null?h:f},this.getBinding=function(){return d===null&&v&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(A=e.getRenderTarget(),s.addEventListener("select",O),s.addEventListener("selectstart",O),s.addEventListener("selectend",O),s.addEventListener("squeeze",O),s.addEventListener("squeezestart",O),s.addEventListener("squeezeend",O),s.addEventListener("end",$),s.addEventListener("inputsourceschange",H),S.xrCompatible!==!0&&await t.makeXRCompatible(),y=e.getPixelRatio(),e.getSize(N),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let he=null,Ve=null,De=null;S.depth&&(De=S.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,he=S.stencil?hr:us,Ve=S.stencil?Zo:es);let ke={colorFormat:t.RGBA8,depthFormat:De,scaleFactor:r};d=this.getBinding(),h=d.createProjectionLayer(ke),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),b=new Ti(h.textureWidth,h.textureHeight,{format:ri,type:Ci,depthTexture:new Ps(h.textureWidth,h.textureHeight,Ve,void 0,void 0,void 0,void 0,void 0,void 0,he),stencilBuffer:S.stencil,colorSpace:e.outputColorSpace,samples:S.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1})}else{let he={antialias:S.antialias,alpha:!0,depth:S.depth,stencil:S.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,he),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new Ti(f.framebufferWidth,f.framebufferHeight,{format:ri,type:Ci,colorSpace:e.outputColorSpace,stencilBuffer:S.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),et.setContext(s),et.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function H(Q){for(let ae=0;ae<Q.removed.length;ae++){let he=Q.removed[ae],Ve=T.indexOf(he);Ve>=0&&(T[Ve]=null,C[Ve].disconnect(he))}for(let ae=0;ae<Q.added.length;ae++){let he=Q.added[ae],Ve=T.indexOf(he);if(Ve===-1){for(let ke=0;ke<C.length;ke++)if(ke>=T.length){T.push(he),Ve=ke;break}else if(T[ke]===null){T[ke]=he,Ve=ke;break}if(Ve===-1)break}let De=C[Ve];De&&De.connect(he)}}let ie=new z,oe=new z;function le(Q,ae,he){ie.setFromMatrixPosition(ae.matrixWorld),oe.setFromMatrixPosition(he.matrixWorld);let Ve=ie.distanceTo(oe),De=ae.projectionMatrix.elements,ke=he.projectionMatrix.elements,wt=De[14]/(De[10]-1),Ye=De[14]/(De[10]+1),pt=(De[9]+1)/De[5],ct=(De[9]-1)/De[5],ot=(De[8]-1)/De[0],qt=(ke[8]+1)/ke[0],en=wt*ot,$t=wt*qt,bt=Ve/(-ot+qt),Ut=bt*-ot;if(ae.matrixWorld.decompose(Q.position,Q.quaternion,Q.scale),Q.translateX(Ut),Q.translateZ(bt),Q.matrixWorld.compose(Q.position,Q.quaternion,Q.scale),Q.matrixWorldInverse.copy(Q.matrixWorld).invert(),De[10]===-1)Q.projectionMatrix.copy(ae.projectionMatrix),Q.projectionMatrixInverse.copy(ae.projectionMatrixInverse);else{let Pt=wt+bt,G=Ye+bt,We=en-Ut,fe=$t+(Ve-Ut),R=pt*Ye/G*Pt,x=ct*Ye/G*Pt;Q.projectionMatrix.makePerspective(We,fe,R,x,Pt,G),Q.projectionMatrixInverse.copy(Q.projectionMatrix).invert()}}function de(Q,ae){ae===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(ae.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let ae=Q.near,he=Q.far;g.texture!==null&&(g.depthNear>0&&(ae=g.depthNear),g.depthFar>0&&(he=g.depthFar)),U.near=F.near=E.near=ae,U.far=F.far=E.far=he,(k!==U.near||X!==U.far)&&(s.updateRenderState({depthNear:U.near,depthFar:U.far}),k=U.near,X=U.far),U.layers.mask=Q.layers.mask|6,E.layers.mask=U.layers.mask&-5,F.layers.mask=U.layers.mask&-3;let Ve=Q.parent,De=U.cameras;de(U,Ve);for(let ke=0;ke<De.length;ke++)de(De[ke],Ve);De.length===2?le(U,E,F):U.projectionMatrix.copy(E.projectionMatrix),ue(Q,U,Ve)};function ue(Q,ae,he){he===null?Q.matrix.copy(ae.matrixWorld):(Q.matrix.copy(he.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(ae.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(ae.projectionMatrix),Q.projectionMatrixInverse.copy(ae.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=zo*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return U},this.getFoveation=function(){if(!(h===null&&f===null))return l},this.setFoveation=function(Q){l=Q,h!==null&&(h.fixedFoveation=Q),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Q)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(U)},this.getCameraTexture=function(Q){return m[Q]};let _e=null;function st(Q,ae){if(u=ae.getViewerPose(c||o),p=ae,u!==null){let he=u.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let Ve=!1;he.length!==U.cameras.length&&(U.cameras.length=0,Ve=!0);for(let Ye=0;Ye<he.length;Ye++){let pt=he[Ye],ct=null;if(f!==null)ct=f.getViewport(pt);else{let qt=d.getViewSubImage(h,pt);ct=qt.viewport,Ye===0&&(e.setRenderTargetTextures(b,qt.colorTexture,qt.depthStencilTexture),e.setRenderTarget(b))}let ot=I[Ye];ot===void 0&&(ot=new Wn,ot.layers.enable(Ye),ot.viewport=new Qt,I[Ye]=ot),ot.matrix.fromArray(pt.transform.matrix),ot.matrix.decompose(ot.position,ot.quaternion,ot.scale),ot.projectionMatrix.fromArray(pt.projectionMatrix),ot.projectionMatrixInverse.copy(ot.projectionMatrix).invert(),ot.viewport.set(ct.x,ct.y,ct.width,ct.height),Ye===0&&(U.matrix.copy(ot.matrix),U.matrix.decompose(U.position,U.quaternion,U.scale)),Ve===!0&&U.cameras.push(ot)}let De=s.enabledFeatures;if(De&&De.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){d=i.getBinding();let Ye=d.getDepthInformation(he[0]);Ye&&Ye.isValid&&Ye.texture&&g.init(Ye,s.renderState)}if(De&&De.includes("camera-access")&&v){e.state.unbindTexture(),d=i.getBinding();for(let Ye=0;Ye<he.length;Ye++){let pt=he[Ye].camera;if(pt){let ct=m[pt];ct||(ct=new Za,m[pt]=ct);let ot=d.getCameraImage(pt);ct.sourceTexture=ot}}}}for(let he=0;he<C.length;he++){let Ve=T[he],De=C[he];Ve!==null&&De!==void 0&&De.update(Ve,ae,c||o)}_e&&_e(Q,ae),ae.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ae}),p=null}let et=new O_;et.setAnimationLoop(st),this.setAnimationLoop=function(Q){_e=Q},this.dispose=function(){}}},YE=new Gt,H_=new it;H_.set(-1,0,0,0,1,0,0,0,1);function ZE(n,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function i(g,m){m.color.getRGB(g.fogColor.value,Of(n)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,S,A,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),d(g,m)):m.isMeshPhongMaterial?(r(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),h(g,m),m.isMeshPhysicalMaterial&&f(g,m,b)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),v(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,S,A):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===si&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===si&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let S=e.get(m),A=S.envMap,b=S.envMapRotation;A&&(g.envMap.value=A,g.envMapRotation.value.setFromMatrix4(YE.makeRotationFromEuler(b)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(H_),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,S,A){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*S,g.scale.value=A*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function d(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function h(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function f(g,m,S){g.ior.value=m.ior,m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===si&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessRange[0],g.iridescenceThicknessMaximum.value=m.iridescenceThicknessRange[1],m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=S.texture,g.transmissionSamplerSize.value.set(S.width,S.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function v(g,m){let S=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(S.matrixWorld),g.nearDistance.value=S.shadow.camera.near,g.farDistance.value=S.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function KE(n,e,t,i){let s={},r={},o=[],a=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function l(b,C){let T=C.program;i.uniformBlockBinding(b,T)}function c(b,C){let T=s[b.id];T===void 0&&(g(b),T=u(b),s[b.id]=T,b.addEventListener("dispose",S));let N=C.program;i.updateUBOMapping(b,N);let y=e.render.frame;r[b.id]!==y&&(h(b),r[b.id]=y)}function u(b){let C=d();b.__bindingPointIndex=C;let T=n.createBuffer(),N=b.__size,y=b.usage;return n.bindBuffer(n.UNIFORM_BUFFER,T),n.bufferData(n.UNIFORM_BUFFER,N,y),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,C,T),T}function d(){for(let b=0;b<a;b++)if(o.indexOf(b)===-1)return o.push(b),b;return Ke("WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function h(b){let C=s[b.id],T=b.uniforms,N=b.__cache;n.bindBuffer(n.UNIFORM_BUFFER,C);for(let y=0,E=T.length;y<E;y++){let F=T[y];if(Array.isArray(F))for(let I=0,U=F.length;I<U;I++)f(F[I],y,I,N);else f(F,y,0,N)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function f(b,C,T,N){if(v(b,C,T,N)===!0){let y=b.__offset,E=b.value;if(Array.isArray(E)){let F=0;for(let I=0;I<E.length;I++){let U=E[I],k=m(U);p(U,b.__data,F),typeof U!="number"&&typeof U!="boolean"&&!U.isMatrix3&&!ArrayBuffer.isView(U)&&(F+=k.storage/Float32Array.BYTES_PER_ELEMENT)}}else p(E,b.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,y,b.__data)}}function p(b,C,T){typeof b=="number"||typeof b=="boolean"?C[0]=b:b.isMatrix3?(C[0]=b.elements[0],C[1]=b.elements[1],C[2]=b.elements[2],C[3]=0,C[4]=b.elements[3],C[5]=b.elements[4],C[6]=b.elements[5],C[7]=0,C[8]=b.elements[6],C[9]=b.elements[7],C[10]=b.elements[8],C[11]=0):ArrayBuffer.isView(b)?C.set(new b.constructor(b.buffer,b.byteOffset,C.length)):b.toArray(C,T)}function v(b,C,T,N){let y=b.value,E=C+"_"+T;if(N[E]===void 0)return typeof y=="number"||typeof y=="boolean"?N[E]=y:ArrayBuffer.isView(y)?N[E]=y.slice():N[E]=y.clone(),!0;{let F=N[E];if(typeof y=="number"||typeof y=="boolean"){if(F!==y)return N[E]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(F.equals(y)===!1)return F.copy(y),!0}}return!1}function g(b){let C=b.uniforms,T=0,N=16;for(let E=0,F=C.length;E<F;E++){let I=Array.isArray(C[E])?C[E]:[C[E]];for(let U=0,k=I.length;U<k;U++){let X=I[U],O=Array.isArray(X.value)?X.value:[X.value];for(let $=0,H=O.length;$<H;$++){let ie=O[$],oe=m(ie),le=T%N,de=le%oe.boundary,ue=le+de;T+=de,ue!==0&&N-ue<oe.storage&&(T+=N-ue),X.__data=new Float32Array(oe.storage/Float32Array.BYTES_PER_ELEMENT),X.__offset=T,T+=oe.storage}}}let y=T%N;return y>0&&(T+=N-y),b.__size=T,b.__cache={},this}function m(b){let C={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(C.boundary=4,C.storage=4):b.isVector2?(C.boundary=8,C.storage=8):b.isVector3||b.isColor?(C.boundary=16,C.storage=12):b.isVector4?(C.boundary=16,C.storage=16):b.isMatrix3?(C.boundary=48,C.storage=48):b.isMatrix4?(C.boundary=64,C.storage=64):b.isTexture?$e("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(b)?(C.boundary=16,C.storage=b.byteLength):$e("WebGLRenderer: Unsupported uniform value type.",b),C}function S(b){let C=b.target;C.removeEventListener("dispose",S);let T=o.indexOf(C.__bindingPointIndex);o.splice(T,1),n.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function A(){for(let b in s)n.deleteBuffer(s[b]);o=[],s={},r={}}return{bind:l,update:c,dispose:A}}var JE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ps=null;function jE(){return ps===null&&(ps=new Gr(JE,16,16,dr,fs),ps.name="DFG_LUT",ps.minFilter=Tn,ps.magFilter=Tn,ps.wrapS=cs,ps.wrapT=cs,ps.generateMipmaps=!1,ps.needsUpdate=!0),ps}var ch=class{constructor(e={}){let{canvas:t=l_(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:h=!1,outputBufferType:f=Ci}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let v=f,g=new Set([Eu,Tu,wu]),m=new Set([Ci,es,Yo,Zo,Mu,Su]),S=new Uint32Array(4),A=new Int32Array(4),b=new z,C=null,T=null,N=[],y=[],E=null;this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Qi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let F=this,I=!1,U=null,k=null,X=null,O=null;this._outputColorSpace=wi;let $=0,H=0,ie=null,oe=-1,le=null,de=new Qt,ue=new Qt,_e=null,st=new xt(0),et=0,Q=t.width,ae=t.height,he=1,Ve=null,De=null,ke=new Qt(0,0,Q,ae),wt=new Qt(0,0,Q,ae),Ye=!1,pt=new $a,ct=!1,ot=!1,qt=new Gt,en=new z,$t=new Qt,bt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ut=!1;function Pt(){return ie===null?he:1}let G=i;function We(w,W){return t.getContext(w,W)}try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"185"}`),t.addEventListener("webglcontextlost",lt,!1),t.addEventListener("webglcontextrestored",ht,!1),t.addEventListener("webglcontextcreationerror",Fn,!1),G===null){let W="webgl2";if(G=We(W,w),G===null)throw We(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}}catch(w){throw Ke("WebGLRenderer: "+w.message),w}let fe,R,x,q,K,ee,me,ge,te,ne,xe,Be,Me,ve,Oe,Xe,qe,V,be,se,Se,Ae,ce;function ze(){fe=new rT(G),fe.init(),Se=new XE(G,fe),R=new J1(G,fe,e,Se),x=new HE(G,fe),R.reversedDepthBuffer&&h&&x.buffers.depth.setReversed(!0),k=G.createFramebuffer(),X=G.createFramebuffer(),O=G.createFramebuffer(),q=new lT(G),K=new RE,ee=new WE(G,fe,x,K,R,Se,q),me=new sT(F),ge=new dS(G),Ae=new Z1(G,ge),te=new oT(G,ge,q,Ae),ne=new uT(G,te,ge,Ae,q),V=new cT(G,R,ee),Oe=new j1(K),xe=new CE(F,me,fe,R,Ae,Oe),Be=new ZE(F,K),Me=new IE,ve=new OE(fe),qe=new Y1(F,me,x,ne,p,l),Xe=new GE(F,ne,R),ce=new KE(G,q,R,x),be=new K1(G,fe,q),se=new aT(G,fe,q),q.programs=xe.programs,F.capabilities=R,F.extensions=fe,F.properties=K,F.renderLists=Me,F.shadowMap=Xe,F.state=x,F.info=q}ze(),v!==Ci&&(E=new dT(v,t.width,t.height,a,s,r));let Ne=new tp(F,G);this.xr=Ne,this.getContext=function(){return G},this.getContextAttributes=function(){return G.getContextAttributes()},this.forceContextLoss=function(){let w=fe.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=fe.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return he},this.setPixelRatio=function(w){w!==void 0&&(he=w,this.setSize(Q,ae,!1))},this.getSize=function(w){return w.set(Q,ae)},this.setSize=function(w,W,j=!0){if(Ne.isPresenting){$e("WebGLRenderer: Can't change size while VR device is presenting.");return}Q=w,ae=W,t.width=Math.floor(w*he),t.height=Math.floor(W*he),j===!0&&(t.style.width=w+"px",t.style.height=W+"px"),E!==null&&E.setSize(t.width,t.height),this.setViewport(0,0,w,W)},this.getDrawingBufferSize=function(w){return w.set(Q*he,ae*he).floor()},this.setDrawingBufferSize=function(w,W,j){Q=w,ae=W,he=j,t.width=Math.floor(w*j),t.height=Math.floor(W*j),this.setViewport(0,0,w,W)},this.setEffects=function(w){if(v===Ci){Ke("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let W=0;W<w.length;W++)if(w[W].isOutputPass===!0){$e("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}E.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(de)},this.getViewport=function(w){return w.copy(ke)},this.setViewport=function(w,W,j,Y){w.isVector4?ke.set(w.x,w.y,w.z,w.w):ke.set(w,W,j,Y),x.viewport(de.copy(ke).multiplyScalar(he).round())},this.getScissor=function(w){return w.copy(wt)},this.setScissor=function(w,W,j,Y){w.isVector4?wt.set(w.x,w.y,w.z,w.w):wt.set(w,W,j,Y),x.scissor(ue.copy(wt).multiplyScalar(he).round())},this.getScissorTest=function(){return Ye},this.setScissorTest=function(w){x.setScissorTest(Ye=w)},this.setOpaqueSort=function(w){Ve=w},this.setTransparentSort=function(w){De=w},this.getClearColor=function(w){return w.copy(qe.getClearColor())},this.setClearColor=function(){qe.setClearColor(...arguments)},this.getClearAlpha=function(){return qe.getClearAlpha()},this.setClearAlpha=function(){qe.setClearAlpha(...arguments)},this.clear=function(w=!0,W=!0,j=!0){let Y=0;if(w){let J=!1;if(ie!==null){let Te=ie.texture.format;J=g.has(Te)}if(J){let Te=ie.texture.type,Pe=m.has(Te),we=qe.getClearColor(),Ue=qe.getClearAlpha(),Ce=we.r,tt=we.g,rt=we.b;Pe?(S[0]=Ce,S[1]=tt,S[2]=rt,S[3]=Ue,G.clearBufferuiv(G.COLOR,0,S)):(A[0]=Ce,A[1]=tt,A[2]=rt,A[3]=Ue,G.clearBufferiv(G.COLOR,0,A))}else Y|=G.COLOR_BUFFER_BIT}W&&(Y|=G.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=G.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&G.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),U=w},this.dispose=function(){t.removeEventListener("webglcontextlost",lt,!1),t.removeEventListener("webglcontextrestored",ht,!1),t.removeEventListener("webglcontextcreationerror",Fn,!1),qe.dispose(),Me.dispose(),ve.dispose(),K.dispose(),me.dispose(),ne.dispose(),Ae.dispose(),ce.dispose(),xe.dispose(),Ne.dispose(),Ne.removeEventListener("sessionstart",Ml),Ne.removeEventListener("sessionend",Sl),$n.stop()};function lt(w){w.preventDefault(),Df("WebGLRenderer: Context Lost."),I=!0}function ht(){Df("WebGLRenderer: Context Restored."),I=!1;let w=q.autoReset,W=Xe.enabled,j=Xe.autoUpdate,Y=Xe.needsUpdate,J=Xe.type;ze(),q.autoReset=w,Xe.enabled=W,Xe.autoUpdate=j,Xe.needsUpdate=Y,Xe.type=J}function Fn(w){Ke("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function Un(w){let W=w.target;W.removeEventListener("dispose",Un),oi(W)}function oi(w){Ns(w),K.remove(w)}function Ns(w){let W=K.get(w).programs;W!==void 0&&(W.forEach(function(j){xe.releaseProgram(j)}),w.isShaderMaterial&&xe.releaseShaderCache(w))}this.renderBufferDirect=function(w,W,j,Y,J,Te){W===null&&(W=bt);let Pe=J.isMesh&&J.matrixWorld.determinantAffine()<0,we=yr(w,W,j,Y,J);x.setMaterial(Y,Pe);let Ue=j.index,Ce=1;if(Y.wireframe===!0){if(Ue=te.getWireframeAttribute(j),Ue===void 0)return;Ce=2}let tt=j.drawRange,rt=j.attributes.position,Ge=tt.start*Ce,Tt=(tt.start+tt.count)*Ce;Te!==null&&(Ge=Math.max(Ge,Te.start*Ce),Tt=Math.min(Tt,(Te.start+Te.count)*Ce)),Ue!==null?(Ge=Math.max(Ge,0),Tt=Math.min(Tt,Ue.count)):rt!=null&&(Ge=Math.max(Ge,0),Tt=Math.min(Tt,rt.count));let on=Tt-Ge;if(on<0||on===1/0)return;Ae.setup(J,Y,we,j,Ue);let tn,Ot=be;if(Ue!==null&&(tn=ge.get(Ue),Ot=se,Ot.setIndex(tn)),J.isMesh)Y.wireframe===!0?(x.setLineWidth(Y.wireframeLinewidth*Pt()),Ot.setMode(G.LINES)):Ot.setMode(G.TRIANGLES);else if(J.isLine){let bn=Y.linewidth;bn===void 0&&(bn=1),x.setLineWidth(bn*Pt()),J.isLineSegments?Ot.setMode(G.LINES):J.isLineLoop?Ot.setMode(G.LINE_LOOP):Ot.setMode(G.LINE_STRIP)}else J.isPoints?Ot.setMode(G.POINTS):J.isSprite&&Ot.setMode(G.TRIANGLES);if(J.isBatchedMesh)if(fe.get("WEBGL_multi_draw"))Ot.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let bn=J._multiDrawStarts,Ie=J._multiDrawCounts,Yn=J._multiDrawCount,mt=Ue?ge.get(Ue).bytesPerElement:1,Vn=K.get(Y).currentProgram.getUniforms();for(let Zn=0;Zn<Yn;Zn++)Vn.setValue(G,"_gl_DrawID",Zn),Ot.render(bn[Zn]/mt,Ie[Zn])}else if(J.isInstancedMesh)Ot.renderInstances(Ge,on,J.count);else if(j.isInstancedBufferGeometry){let bn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ie=Math.min(j.instanceCount,bn);Ot.renderInstances(Ge,on,Ie)}else Ot.render(Ge,on)};function _s(w,W,j){w.transparent===!0&&w.side===ui&&w.forceSinglePass===!1?(w.side=si,w.needsUpdate=!0,rn(w,W,j),w.side=Ji,w.needsUpdate=!0,rn(w,W,j),w.side=ui):rn(w,W,j)}this.compile=function(w,W,j=null){j===null&&(j=w),T=ve.get(j),T.init(W),y.push(T),j.traverseVisible(function(J){J.isLight&&J.layers.test(W.layers)&&(T.pushLight(J),J.castShadow&&T.pushShadow(J))}),w!==j&&w.traverseVisible(function(J){J.isLight&&J.layers.test(W.layers)&&(T.pushLight(J),J.castShadow&&T.pushShadow(J))}),T.setupLights();let Y=new Set;return w.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Te=J.material;if(Te)if(Array.isArray(Te))for(let Pe=0;Pe<Te.length;Pe++){let we=Te[Pe];_s(we,j,J),Y.add(we)}else _s(Te,j,J),Y.add(Te)}),T=y.pop(),Y},this.compileAsync=function(w,W,j=null){let Y=this.compile(w,W,j);return new Promise(J=>{function Te(){if(Y.forEach(function(Pe){K.get(Pe).currentProgram.isReady()&&Y.delete(Pe)}),Y.size===0){J(w);return}setTimeout(Te,10)}fe.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let Kr=null;function bl(w){Kr&&Kr(w)}function Ml(){$n.stop()}function Sl(){$n.start()}let $n=new O_;$n.setAnimationLoop(bl),typeof self<"u"&&$n.setContext(self),this.setAnimationLoop=function(w){Kr=w,Ne.setAnimationLoop(w),w===null?$n.stop():$n.start()},Ne.addEventListener("sessionstart",Ml),Ne.addEventListener("sessionend",Sl),this.render=function(w,W){if(W!==void 0&&W.isCamera!==!0){Ke("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;U!==null&&U.renderStart(w,W);let j=Ne.enabled===!0&&Ne.isPresenting===!0,Y=E!==null&&(ie===null||j)&&E.begin(F,ie);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),Ne.enabled===!0&&Ne.isPresenting===!0&&(E===null||E.isCompositing()===!1)&&(Ne.cameraAutoUpdate===!0&&Ne.updateCamera(W),W=Ne.getCamera()),w.isScene===!0&&w.onBeforeRender(F,w,W,ie),T=ve.get(w,y.length),T.init(W),T.state.textureUnits=ee.getTextureUnits(),y.push(T),qt.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),pt.setFromProjectionMatrix(qt,Zi,W.reversedDepth),ot=this.localClippingEnabled,ct=Oe.init(this.clippingPlanes,ot),C=Me.get(w,N.length),C.init(),N.push(C),Ne.enabled===!0&&Ne.isPresenting===!0){let Pe=F.xr.getDepthSensingMesh();Pe!==null&&ra(Pe,W,-1/0,F.sortObjects)}ra(w,W,0,F.sortObjects),C.finish(),F.sortObjects===!0&&C.sort(Ve,De,W.reversedDepth),Ut=Ne.enabled===!1||Ne.isPresenting===!1||Ne.hasDepthSensing()===!1,Ut&&qe.addToRenderList(C,w),this.info.render.frame++,this.info.autoReset===!0&&this.info.reset(),ct===!0&&Oe.beginShadows();let J=T.state.shadowsArray;if(Xe.render(J,w,W),ct===!0&&Oe.endShadows(),(Y&&E.hasRenderPass())===!1){let Pe=C.opaque,we=C.transmissive;if(T.setupLights(),W.isArrayCamera){let Ue=W.cameras;if(we.length>0)for(let Ce=0,tt=Ue.length;Ce<tt;Ce++){let rt=Ue[Ce];oa(Pe,we,w,rt)}Ut&&qe.render(w);for(let Ce=0,tt=Ue.length;Ce<tt;Ce++){let rt=Ue[Ce];Ds(C,w,rt,rt.viewport)}}else we.length>0&&oa(Pe,we,w,W),Ut&&qe.render(w),Ds(C,w,W)}ie!==null&&H===0&&(ee.updateMultisampleRenderTarget(ie),ee.updateRenderTargetMipmap(ie)),Y&&E.end(F),w.isScene===!0&&w.onAfterRender(F,w,W),Ae.resetDefaultState(),oe=-1,le=null,y.pop(),y.length>0?(T=y[y.length-1],ee.setTextureUnits(T.state.textureUnits),ct===!0&&Oe.setGlobalState(F.clippingPlanes,T.state.camera)):T=null,N.pop(),N.length>0?C=N[N.length-1]:C=null,U!==null&&U.renderEnd()};function ra(w,W,j,Y){if(w.visible===!1)return;if(w.layers.test(W.layers)){if(w.isGroup)j=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(W);else if(w.isLightProbeGrid)T.pushLightProbeGrid(w);else if(w.isLight)T.pushLight(w),w.castShadow&&T.pushShadow(w);else if(w.isSprite){if(!w.frustumCulled||pt.intersectsSprite(w)){Y&&$t.setFromMatrixPosition(w.matrixWorld).applyMatrix4(qt);let Pe=ne.update(w),we=w.material;we.visible&&C.push(w,Pe,we,j,$t.z,null)}}else if((w.isMesh||w.isLine||w.isPoints)&&(!w.frustumCulled||pt.intersectsObject(w))){let Pe=ne.update(w),we=w.material;if(Y&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),$t.copy(w.boundingSphere.center)):(Pe.boundingSphere===null&&Pe.computeBoundingSphere(),$t.copy(Pe.boundingSphere.center)),$t.applyMatrix4(w.matrixWorld).applyMatrix4(qt)),Array.isArray(we)){let Ue=Pe.groups;for(let Ce=0,tt=Ue.length;Ce<tt;Ce++){let rt=Ue[Ce],Ge=we[rt.materialIndex];Ge&&Ge.visible&&C.push(w,Pe,Ge,j,$t.z,rt)}}else we.visible&&C.push(w,Pe,we,j,$t.z,null)}}let Te=w.children;for(let Pe=0,we=Te.length;Pe<we;Pe++)ra(Te[Pe],W,j,Y)}function Ds(w,W,j,Y){let{opaque:J,transmissive:Te,transparent:Pe}=w;T.setupLightsView(j),ct===!0&&Oe.setGlobalState(F.clippingPlanes,j),Y&&x.viewport(de.copy(Y)),J.length>0&&di(J,W,j),Te.length>0&&di(Te,W,j),Pe.length>0&&di(Pe,W,j),x.buffers.depth.setTest(!0),x.buffers.depth.setMask(!0),x.buffers.color.setMask(!0),x.setPolygonOffset(!1)}function oa(w,W,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[Y.id]===void 0){let Ge=fe.has("EXT_color_buffer_half_float")||fe.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[Y.id]=new Ti(1,1,{generateMipmaps:!0,type:Ge?fs:Ci,minFilter:ur,samples:Math.max(4,R.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:_t.workingColorSpace})}let Te=T.state.transmissionRenderTarget[Y.id],Pe=Y.viewport||de;Te.setSize(Pe.z*F.transmissionResolutionScale,Pe.w*F.transmissionResolutionScale);let we=F.getRenderTarget(),Ue=F.getActiveCubeFace(),Ce=F.getActiveMipmapLevel();F.setRenderTarget(Te),F.getClearColor(st),et=F.getClearAlpha(),et<1&&F.setClearColor(16777215,.5),F.clear(),Ut&&qe.render(j);let tt=F.toneMapping;F.toneMapping=Qi;let rt=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),T.setupLightsView(Y),ct===!0&&Oe.setGlobalState(F.clippingPlanes,Y),di(w,j,Y),ee.updateMultisampleRenderTarget(Te),ee.updateRenderTargetMipmap(Te),fe.has("WEBGL_multisampled_render_to_texture")===!1){let Ge=!1;for(let Tt=0,on=W.length;Tt<on;Tt++){let tn=W[Tt],{object:Ot,geometry:bn,material:Ie,group:Yn}=tn;if(Ie.side===ui&&Ot.layers.test(Y.layers)){let mt=Ie.side;Ie.side=si,Ie.needsUpdate=!0,mn(Ot,j,Y,bn,Ie,Yn),Ie.side=mt,Ie.needsUpdate=!0,Ge=!0}}Ge===!0&&(ee.updateMultisampleRenderTarget(Te),ee.updateRenderTargetMipmap(Te))}F.setRenderTarget(we,Ue,Ce),F.setClearColor(st,et),rt!==void 0&&(Y.viewport=rt),F.toneMapping=tt}function di(w,W,j){let Y=W.isScene===!0?W.overrideMaterial:null;for(let J=0,Te=w.length;J<Te;J++){let Pe=w[J],{object:we,geometry:Ue,group:Ce}=Pe,tt=Pe.material;tt.allowOverride===!0&&Y!==null&&(tt=Y),we.layers.test(j.layers)&&mn(we,W,j,Ue,tt,Ce)}}function mn(w,W,j,Y,J,Te){w.onBeforeRender(F,W,j,Y,J,Te),w.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),J.onBeforeRender(F,W,j,Y,w,Te),J.transparent===!0&&J.side===ui&&J.forceSinglePass===!1?(J.side=si,J.needsUpdate=!0,F.renderBufferDirect(j,W,Y,J,w,Te),J.side=Ji,J.needsUpdate=!0,F.renderBufferDirect(j,W,Y,J,w,Te),J.side=ui):F.renderBufferDirect(j,W,Y,J,w,Te),w.onAfterRender(F,W,j,Y,J,Te)}function rn(w,W,j){W.isScene!==!0&&(W=bt);let Y=K.get(w),J=T.state.lights,Te=T.state.shadowsArray,Pe=J.state.version,we=xe.getParameters(w,J.state,Te,W,j,T.state.lightProbeGridArray),Ue=xe.getProgramCacheKey(we),Ce=Y.programs;Y.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?W.environment:null,Y.fog=W.fog;let tt=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;Y.envMap=me.get(w.envMap||Y.environment,tt),Y.envMapRotation=Y.environment!==null&&w.envMap===null?W.environmentRotation:w.envMapRotation,Ce===void 0&&(w.addEventListener("dispose",Un),Ce=new Map,Y.programs=Ce);let rt=Ce.get(Ue);if(rt!==void 0){if(Y.currentProgram===rt&&Y.lightsStateVersion===Pe)return xr(w,we),rt}else we.uniforms=xe.getUniforms(w),U!==null&&w.isNodeMaterial&&U.build(w,j,we),w.onBeforeCompile(we,F),rt=xe.acquireProgram(we,Ue),Ce.set(Ue,rt),Y.uniforms=we.uniforms;let Ge=Y.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Ge.clippingPlanes=Oe.uniform),xr(w,we),Y.needsLights=aa(w),Y.lightsStateVersion=Pe,Y.needsLights&&(Ge.ambientLightColor.value=J.state.ambient,Ge.lightProbe.value=J.state.probe,Ge.directionalLights.value=J.state.directional,Ge.directionalLightShadows.value=J.state.directionalShadow,Ge.spotLights.value=J.state.spot,Ge.spotLightShadows.value=J.state.spotShadow,Ge.rectAreaLights.value=J.state.rectArea,Ge.ltc_1.value=J.state.rectAreaLTC1,Ge.ltc_2.value=J.state.rectAreaLTC2,Ge.pointLights.value=J.state.point,Ge.pointLightShadows.value=J.state.pointShadow,Ge.hemisphereLights.value=J.state.hemi,Ge.directionalShadowMatrix.value=J.state.directionalShadowMatrix,Ge.spotLightMatrix.value=J.state.spotLightMatrix,Ge.spotLightMap.value=J.state.spotLightMap,Ge.pointShadowMatrix.value=J.state.pointShadowMatrix),Y.lightProbeGrid=T.state.lightProbeGridArray.length>0,Y.currentProgram=rt,Y.uniformsList=null,rt}function fn(w){if(w.uniformsList===null){let W=w.currentProgram.getUniforms();w.uniformsList=jo.seqWithValue(W.seq,w.uniforms)}return w.uniformsList}function xr(w,W){let j=K.get(w);j.outputColorSpace=W.outputColorSpace,j.batching=W.batching,j.batchingColor=W.batchingColor,j.instancing=W.instancing,j.instancingColor=W.instancingColor,j.instancingMorph=W.instancingMorph,j.skinning=W.skinning,j.morphTargets=W.morphTargets,j.morphNormals=W.morphNormals,j.morphColors=W.morphColors,j.morphTargetsCount=W.morphTargetsCount,j.numClippingPlanes=W.numClippingPlanes,j.numIntersection=W.numClipIntersection,j.vertexAlphas=W.vertexAlphas,j.vertexTangents=W.vertexTangents,j.toneMapping=W.toneMapping}function fi(w,W){if(w.length===0)return null;if(w.length===1)return w[0].texture!==null?w[0]:null;b.setFromMatrixPosition(W.matrixWorld);for(let j=0,Y=w.length;j<Y;j++){let J=w[j];if(J.texture!==null&&J.boundingBox.containsPoint(b))return J}return null}function yr(w,W,j,Y,J){W.isScene!==!0&&(W=bt),ee.resetTextureUnits();let Te=W.fog,Pe=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?W.environment:null,we=ie===null?F.outputColorSpace:ie.isXRRenderTarget===!0?ie.texture.colorSpace:_t.workingColorSpace,Ue=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Ce=me.get(Y.envMap||Pe,Ue),tt=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,rt=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Ge=!!j.morphAttributes.position,Tt=!!j.morphAttributes.normal,on=!!j.morphAttributes.color,tn=Qi;Y.toneMapped&&(ie===null||ie.isXRRenderTarget===!0)&&(tn=F.toneMapping);let Ot=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,bn=Ot!==void 0?Ot.length:0,Ie=K.get(Y),Yn=T.state.lights;if(ct===!0&&(ot===!0||w!==le)){let Vt=w===le&&Y.id===oe;Oe.setState(Y,w,Vt)}let mt=!1;Y.version===Ie.__version?(Ie.needsLights&&Ie.lightsStateVersion!==Yn.state.version||Ie.outputColorSpace!==we||J.isBatchedMesh&&Ie.batching===!1||!J.isBatchedMesh&&Ie.batching===!0||J.isBatchedMesh&&Ie.batchingColor===!0&&J.colorTexture===null||J.isBatchedMesh&&Ie.batchingColor===!1&&J.colorTexture!==null||J.isInstancedMesh&&Ie.instancing===!1||!J.isInstancedMesh&&Ie.instancing===!0||J.isSkinnedMesh&&Ie.skinning===!1||!J.isSkinnedMesh&&Ie.skinning===!0||J.isInstancedMesh&&Ie.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Ie.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Ie.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Ie.instancingMorph===!1&&J.morphTexture!==null||Ie.envMap!==Ce||Y.fog===!0&&Ie.fog!==Te||Ie.numClippingPlanes!==void 0&&(Ie.numClippingPlanes!==Oe.numPlanes||Ie.numIntersection!==Oe.numIntersection)||Ie.vertexAlphas!==tt||Ie.vertexTangents!==rt||Ie.morphTargets!==Ge||Ie.morphNormals!==Tt||Ie.morphColors!==on||Ie.toneMapping!==tn||Ie.morphTargetsCount!==bn||!!Ie.lightProbeGrid!=T.state.lightProbeGridArray.length>0)&&(mt=!0):(mt=!0,Ie.__version=Y.version);let Vn=Ie.currentProgram;mt===!0&&(Vn=rn(Y,W,J),U&&Y.isNodeMaterial&&U.onUpdateProgram(Y,Vn,Ie));let Zn=!1,pi=!1,Fs=!1,Et=Vn.getUniforms(),an=Ie.uniforms;if(x.useProgram(Vn.program)&&(Zn=!0,pi=!0,Fs=!0),Y.id!==oe&&(oe=Y.id,pi=!0),Ie.needsLights){let Vt=fi(T.state.lightProbeGridArray,J);Ie.lightProbeGrid!==Vt&&(Ie.lightProbeGrid=Vt,pi=!0)}if(Zn||le!==w){x.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),Et.setValue(G,"projectionMatrix",w.projectionMatrix),Et.setValue(G,"viewMatrix",w.matrixWorldInverse);let Kn=Et.map.cameraPosition;Kn!==void 0&&Kn.setValue(G,en.setFromMatrixPosition(w.matrixWorld)),R.logarithmicDepthBuffer&&Et.setValue(G,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&Et.setValue(G,"isOrthographic",w.isOrthographicCamera===!0),le!==w&&(le=w,pi=!0,Fs=!0)}if(Ie.needsLights&&(Yn.state.directionalShadowMap.length>0&&Et.setValue(G,"directionalShadowMap",Yn.state.directionalShadowMap,ee),Yn.state.spotShadowMap.length>0&&Et.setValue(G,"spotShadowMap",Yn.state.spotShadowMap,ee),Yn.state.pointShadowMap.length>0&&Et.setValue(G,"pointShadowMap",Yn.state.pointShadowMap,ee)),J.isSkinnedMesh){Et.setOptional(G,J,"bindMatrix"),Et.setOptional(G,J,"bindMatrixInverse");let Vt=J.skeleton;Vt&&(Vt.boneTexture===null&&Vt.computeBoneTexture(),Et.setValue(G,"boneTexture",Vt.boneTexture,ee))}J.isBatchedMesh&&(Et.setOptional(G,J,"batchingTexture"),Et.setValue(G,"batchingTexture",J._matricesTexture,ee),Et.setOptional(G,J,"batchingIdTexture"),Et.setValue(G,"batchingIdTexture",J._indirectTexture,ee),Et.setOptional(G,J,"batchingColorTexture"),J._colorsTexture!==null&&Et.setValue(G,"batchingColorTexture",J._colorsTexture,ee));let ts=j.morphAttributes;if((ts.position!==void 0||ts.normal!==void 0||ts.color!==void 0)&&V.update(J,j,Vn),(pi||Ie.receiveShadow!==J.receiveShadow)&&(Ie.receiveShadow=J.receiveShadow,Et.setValue(G,"receiveShadow",J.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&W.environment!==null&&(an.envMapIntensity.value=W.environmentIntensity),an.dfgLUT!==void 0&&(an.dfgLUT.value=jE()),pi){if(Et.setValue(G,"toneMappingExposure",F.toneMappingExposure),Ie.needsLights&&wl(an,Fs),Te&&Y.fog===!0&&Be.refreshFogUniforms(an,Te),Be.refreshMaterialUniforms(an,Y,he,ae,T.state.transmissionRenderTarget[w.id]),Ie.needsLights&&Ie.lightProbeGrid){let Vt=Ie.lightProbeGrid;an.probesSH.value=Vt.texture,an.probesMin.value.copy(Vt.boundingBox.min),an.probesMax.value.copy(Vt.boundingBox.max),an.probesResolution.value.copy(Vt.resolution)}jo.upload(G,fn(Ie),an,ee)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(jo.upload(G,fn(Ie),an,ee),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&Et.setValue(G,"center",J.center),Et.setValue(G,"modelViewMatrix",J.modelViewMatrix),Et.setValue(G,"normalMatrix",J.normalMatrix),Et.setValue(G,"modelMatrix",J.matrixWorld),Y.uniformsGroups!==void 0){let Vt=Y.uniformsGroups;for(let Kn=0,ki=Vt.length;Kn<ki;Kn++){let Jr=Vt[Kn];ce.update(Jr,Vn),ce.bind(Jr,Vn)}}return Vn}function wl(w,W){w.ambientLightColor.needsUpdate=W,w.lightProbe.needsUpdate=W,w.directionalLights.needsUpdate=W,w.directionalLightShadows.needsUpdate=W,w.pointLights.needsUpdate=W,w.pointLightShadows.needsUpdate=W,w.spotLights.needsUpdate=W,w.spotLightShadows.needsUpdate=W,w.rectAreaLights.needsUpdate=W,w.hemisphereLights.needsUpdate=W}function aa(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return ie},this.setRenderTargetTextures=function(w,W,j){let Y=K.get(w);Y.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),K.get(w.texture).__webglTexture=W,K.get(w.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,W){let j=K.get(w);j.__webglFramebuffer=W,j.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(w,W=0,j=0){ie=w,$=W,H=j;let Y=null,J=!1,Te=!1;if(w){let we=K.get(w);if(we.__useDefaultFramebuffer!==void 0){x.bindFramebuffer(G.FRAMEBUFFER,we.__webglFramebuffer),de.copy(w.viewport),ue.copy(w.scissor),_e=w.scissorTest,x.viewport(de),x.scissor(ue),x.setScissorTest(_e),oe=-1;return}else if(we.__webglFramebuffer===void 0)ee.setupRenderTarget(w);else if(we.__hasExternalTextures)ee.rebindTextures(w,K.get(w.texture).__webglTexture,K.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let tt=w.depthTexture;if(we.__boundDepthTexture!==tt){if(tt!==null&&K.has(tt)&&(w.width!==tt.image.width||w.height!==tt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");ee.setupDepthRenderbuffer(w)}}let Ue=w.texture;(Ue.isData3DTexture||Ue.isDataArrayTexture||Ue.isCompressedArrayTexture)&&(Te=!0);let Ce=K.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Ce[W])?Y=Ce[W][j]:Y=Ce[W],J=!0):w.samples>0&&ee.useMultisampledRTT(w)===!1?Y=K.get(w).__webglMultisampledFramebuffer:Array.isArray(Ce)?Y=Ce[j]:Y=Ce,de.copy(w.viewport),ue.copy(w.scissor),_e=w.scissorTest}else de.copy(ke).multiplyScalar(he).floor(),ue.copy(wt).multiplyScalar(he).floor(),_e=Ye;if(j!==0&&(Y=k),x.bindFramebuffer(G.FRAMEBUFFER,Y)&&x.drawBuffers(w,Y),x.viewport(de),x.scissor(ue),x.setScissorTest(_e),J){let we=K.get(w.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_CUBE_MAP_POSITIVE_X+W,we.__webglTexture,j)}else if(Te){let we=W;for(let Ue=0;Ue<w.textures.length;Ue++){let Ce=K.get(w.textures[Ue]);G.framebufferTextureLayer(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0+Ue,Ce.__webglTexture,j,we)}}else if(w!==null&&j!==0){let we=K.get(w.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,we.__webglTexture,j)}oe=-1},this.readRenderTargetPixels=function(w,W,j,Y,J,Te,Pe,we=0){if(!(w&&w.isWebGLRenderTarget)){Ke("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ue=K.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ue=Ue[Pe]),Ue){x.bindFramebuffer(G.FRAMEBUFFER,Ue);try{let Ce=w.textures[we],tt=Ce.format,rt=Ce.type;if(w.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+we),!R.textureFormatReadable(tt)){Ke("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!R.textureTypeReadable(rt)){Ke("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=w.width-Y&&j>=0&&j<=w.height-J&&G.readPixels(W,j,Y,J,Se.convert(tt),Se.convert(rt),Te)}finally{let Ce=ie!==null?K.get(ie).__webglFramebuffer:null;x.bindFramebuffer(G.FRAMEBUFFER,Ce)}}},this.readRenderTargetPixelsAsync=async function(w,W,j,Y,J,Te,Pe,we=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ue=K.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ue=Ue[Pe]),Ue)if(W>=0&&W<=w.width-Y&&j>=0&&j<=w.height-J){x.bindFramebuffer(G.FRAMEBUFFER,Ue);let Ce=w.textures[we],tt=Ce.format,rt=Ce.type;if(w.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+we),!R.textureFormatReadable(tt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!R.textureTypeReadable(rt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Ge=G.createBuffer();G.bindBuffer(G.PIXEL_PACK_BUFFER,Ge),G.bufferData(G.PIXEL_PACK_BUFFER,Te.byteLength,G.STREAM_READ),G.readPixels(W,j,Y,J,Se.convert(tt),Se.convert(rt),0);let Tt=ie!==null?K.get(ie).__webglFramebuffer:null;x.bindFramebuffer(G.FRAMEBUFFER,Tt);let on=G.fenceSync(G.SYNC_GPU_COMMANDS_COMPLETE,0);return G.flush(),await u_(G,on,4),G.bindBuffer(G.PIXEL_PACK_BUFFER,Ge),G.getBufferSubData(G.PIXEL_PACK_BUFFER,0,Te),G.deleteBuffer(Ge),G.deleteSync(on),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,W=null,j=0){let Y=Math.pow(2,-j),J=Math.floor(w.image.width*Y),Te=Math.floor(w.image.height*Y),Pe=W!==null?W.x:0,we=W!==null?W.y:0;ee.setTexture2D(w,0),G.copyTexSubImage2D(G.TEXTURE_2D,j,0,0,Pe,we,J,Te),x.unbindTexture()},this.copyTextureToTexture=function(w,W,j=null,Y=null,J=0,Te=0){let Pe,we,Ue,Ce,tt,rt,Ge,Tt,on,tn=w.isCompressedTexture?w.mipmaps[Te]:w.image;if(j!==null)Pe=j.max.x-j.min.x,we=j.max.y-j.min.y,Ue=j.isBox3?j.max.z-j.min.z:1,Ce=j.min.x,tt=j.min.y,rt=j.isBox3?j.min.z:0;else{let an=Math.pow(2,-J);Pe=Math.floor(tn.width*an),we=Math.floor(tn.height*an),w.isDataArrayTexture?Ue=tn.depth:w.isData3DTexture?Ue=Math.floor(tn.depth*an):Ue=1,Ce=0,tt=0,rt=0}Y!==null?(Ge=Y.x,Tt=Y.y,on=Y.z):(Ge=0,Tt=0,on=0);let Ot=Se.convert(W.format),bn=Se.convert(W.type),Ie;W.isData3DTexture?(ee.setTexture3D(W,0),Ie=G.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?(ee.setTexture2DArray(W,0),Ie=G.TEXTURE_2D_ARRAY):(ee.setTexture2D(W,0),Ie=G.TEXTURE_2D),x.activeTexture(G.TEXTURE0),x.pixelStorei(G.UNPACK_FLIP_Y_WEBGL,W.flipY),x.pixelStorei(G.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),x.pixelStorei(G.UNPACK_ALIGNMENT,W.unpackAlignment);let Yn=x.getParameter(G.UNPACK_ROW_LENGTH),mt=x.getParameter(G.UNPACK_IMAGE_HEIGHT),Vn=x.getParameter(G.UNPACK_SKIP_PIXELS),Zn=x.getParameter(G.UNPACK_SKIP_ROWS),pi=x.getParameter(G.UNPACK_SKIP_IMAGES);x.pixelStorei(G.UNPACK_ROW_LENGTH,tn.width),x.pixelStorei(G.UNPACK_IMAGE_HEIGHT,tn.height),x.pixelStorei(G.UNPACK_SKIP_PIXELS,Ce),x.pixelStorei(G.UNPACK_SKIP_ROWS,tt),x.pixelStorei(G.UNPACK_SKIP_IMAGES,rt);let Fs=w.isDataArrayTexture||w.isData3DTexture,Et=W.isDataArrayTexture||W.isData3DTexture;if(w.isDepthTexture){let an=K.get(w),ts=K.get(W),Vt=K.get(an.__renderTarget),Kn=K.get(ts.__renderTarget);x.bindFramebuffer(G.READ_FRAMEBUFFER,Vt.__webglFramebuffer),x.bindFramebuffer(G.DRAW_FRAMEBUFFER,Kn.__webglFramebuffer);for(let ki=0;ki<Ue;ki++)Fs&&(G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,K.get(w).__webglTexture,J,rt+ki),G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,K.get(W).__webglTexture,Te,on+ki)),G.blitFramebuffer(Ce,tt,Pe,we,Ge,Tt,Pe,we,G.DEPTH_BUFFER_BIT,G.NEAREST);x.bindFramebuffer(G.READ_FRAMEBUFFER,null),x.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else if(J!==0||w.isRenderTargetTexture||K.has(w)){let an=K.get(w),ts=K.get(W);x.bindFramebuffer(G.READ_FRAMEBUFFER,X),x.bindFramebuffer(G.DRAW_FRAMEBUFFER,O);for(let Vt=0;Vt<Ue;Vt++)Fs?G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,an.__webglTexture,J,rt+Vt):G.framebufferTexture2D(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,an.__webglTexture,J),Et?G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,ts.__webglTexture,Te,on+Vt):G.framebufferTexture2D(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,ts.__webglTexture,Te),J!==0?G.blitFramebuffer(Ce,tt,Pe,we,Ge,Tt,Pe,we,G.COLOR_BUFFER_BIT,G.NEAREST):Et?G.copyTexSubImage3D(Ie,Te,Ge,Tt,on+Vt,Ce,tt,Pe,we):G.copyTexSubImage2D(Ie,Te,Ge,Tt,Ce,tt,Pe,we);x.bindFramebuffer(G.READ_FRAMEBUFFER,null),x.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else Et?w.isDataTexture||w.isData3DTexture?G.texSubImage3D(Ie,Te,Ge,Tt,on,Pe,we,Ue,Ot,bn,tn.data):W.isCompressedArrayTexture?G.compressedTexSubImage3D(Ie,Te,Ge,Tt,on,Pe,we,Ue,Ot,tn.data):G.texSubImage3D(Ie,Te,Ge,Tt,on,Pe,we,Ue,Ot,bn,tn):w.isDataTexture?G.texSubImage2D(G.TEXTURE_2D,Te,Ge,Tt,Pe,we,Ot,bn,tn.data):w.isCompressedTexture?G.compressedTexSubImage2D(G.TEXTURE_2D,Te,Ge,Tt,tn.width,tn.height,Ot,tn.data):G.texSubImage2D(G.TEXTURE_2D,Te,Ge,Tt,Pe,we,Ot,bn,tn);x.pixelStorei(G.UNPACK_ROW_LENGTH,Yn),x.pixelStorei(G.UNPACK_IMAGE_HEIGHT,mt),x.pixelStorei(G.UNPACK_SKIP_PIXELS,Vn),x.pixelStorei(G.UNPACK_SKIP_ROWS,Zn),x.pixelStorei(G.UNPACK_SKIP_IMAGES,pi),Te===0&&W.generateMipmaps&&G.generateMipmap(Ie),x.unbindTexture()},this.initRenderTarget=function(w){K.get(w).__webglFramebuffer===void 0&&ee.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?ee.setTextureCube(w,0):w.isData3DTexture?ee.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?ee.setTexture2DArray(w,0):ee.setTexture2D(w,0),x.unbindTexture()},this.resetState=function(){$=0,H=0,ie=null,x.reset(),Ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Zi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=_t._getDrawingBufferColorSpace(e),t.unpackColorSpace=_t._getUnpackColorSpace()}};var dh=class{constructor(e){this.chain=e;let t=e.segments,i=Math.min(4,Math.max(1,Math.round(3600/Math.max(1,t)))),s=[];for(let r=0;r<t;){let o=r;for(;o+1<t&&e.diameter_m[o+1]===e.diameter_m[r]&&e.part[o+1]===e.part[r];)o++;let a=s.length,l=(o-r+1)*i;for(let c=0;c<=l;c++)s.push(r-.5+c/i);this.stretches.push({first:a,last:s.length-1,part:e.part[r]??0}),r=o+1}this.coordinate=Float32Array.from(s),this.rows=Math.max(1,Math.ceil(s.length/512)),this.texels=new Float32Array(this.rows*512*3*4),this.radius=new Float32Array(s.length);for(let{first:r,last:o}of this.stretches){let a=Math.min(t-1,Math.round(s[r]+.5));this.radius.fill(.5*(e.diameter_m[a]??.05),r,o+1)}this.arc=this.arcs()}chain;coordinate;arc;radius;stretches=[];texels;rows;get count(){return this.coordinate.length}arcs(){let e=new Float64Array(this.chain.segments+1);return this.chain.length_m.forEach((t,i)=>e[i+1]=e[i]+t),this.coordinate.map(t=>{let i=Math.min(this.chain.segments-1,Math.floor(t+.5));return e[i]+(t+.5-i)*(this.chain.length_m[i]??0)})}update(e,t){let{texels:i,coordinate:s}=this,r=this.chain.segments-1;for(let o=0;o<this.count;o++){let a=s[o],l=Math.min(Math.max(0,r-1),Math.max(0,Math.floor(a))),c=Math.min(r,l+1),u=Math.max(0,l-1),d=Math.min(r,c+1),h=a-l,f=12*o;for(let v=0;v<3;v++){let g=e[3*l+v],m=e[3*c+v];if(h<0||h>1){i[f+v]=g+h*(m-g);continue}let S=u<l?.5*(m-e[3*u+v]):m-g,A=d>c?.5*(e[3*d+v]-g):m-g,b=m-g;i[f+v]=g+h*(S+h*(3*b-2*S-A+h*(S+A-2*b)))}let p=Math.min(1,Math.max(0,h));i[f+3]=t[l]+p*(t[c]-t[l]),i[f+7]=this.radius[o],i[f+11]=this.arc[o]}for(let o of this.stretches)this.frame(o)}frame({first:e,last:t}){let i=this.texels,s=12,r=1,o=0,a=0,l=0,c=0,u=0;for(let d=e;d<=t;d++){let h=s*Math.max(e,d-1),f=s*Math.min(t,d+1),p=i[f]-i[h],v=i[f+1]-i[h+1],g=i[f+2]-i[h+2],m=Math.sqrt(p*p+v*v+g*g);m>1e-6&&(r=p/m,o=v/m,a=g/m);let S=l*r+c*o+u*a;l-=S*r,c-=S*o,u-=S*a;let A=Math.sqrt(l*l+c*c+u*u);if(A<.1){let C=Math.abs(a)>.9;S=C?r:a,l=(C?1:0)-S*r,c=-S*o,u=(C?0:1)-S*a,A=Math.sqrt(l*l+c*c+u*u)}l/=A,c/=A,u/=A;let b=s*d;i[b+4]=l,i[b+5]=c,i[b+6]=u,i[b+8]=r,i[b+9]=o,i[b+10]=a}}};var W_=()=>({factor:{value:1},pixel:{value:.001},reel:{value:new Qt(0,0,0,0)},reelAxis:{value:new z(0,1,0)},light:{value:new Je(.62,.42)}}),ea=`
uniform float factor;
uniform vec4 reel;
uniform vec3 reelAxis;
float spreadBy(vec3 place) {
  if (reel.w <= 0.0) return factor;
  vec3 r = place - reel.xyz;
  r -= dot(r, reelAxis) * reelAxis;
  return mix(1.0, factor, smoothstep(1.1, 2.5, length(r) / reel.w));
}
`,ta=`
uniform vec2 light;
vec3 lit(vec3 colour, vec3 normal, vec3 eye, float gloss) {
  vec3 lamp = normalize(vec3(-0.45, 0.75, 0.6));
  float sky = 0.5 + 0.5 * dot(normal, normalize((viewMatrix * vec4(0.0, 0.0, 1.0, 0.0)).xyz));
  float key = max(dot(normal, lamp), 0.0);
  float shine = pow(max(dot(normal, normalize(lamp + eye)), 0.0), 40.0);
  return colour * (light.x * (0.72 + 0.28 * sky) + light.y * key) + gloss * shine;
}
`;var Oi=12,QE=`
${ea}
uniform sampler2D rings;
uniform float pixel;
uniform float thinnest;
attribute vec4 corner;     // ring, cosine and sine of the angle round it, -1 or 1 on the ends' faces
attribute float rim;       // 0 in the middle of an end's face
varying vec3 at;
varying vec3 around;
varying float value;
varying float arc;
void main() {
  int ring = int(corner.x + 0.5);
  ivec2 texel = ivec2((ring % ${512}) * ${3}, ring / ${512});
  vec4 centre = texelFetch(rings, texel, 0);
  vec4 normal = texelFetch(rings, texel + ivec2(1, 0), 0);
  vec4 tangent = texelFetch(rings, texel + ivec2(2, 0), 0);
  vec3 out_ = corner.y * normal.xyz + corner.z * cross(tangent.xyz, normal.xyz);
  float depth = -(viewMatrix * vec4(centre.xyz, 1.0)).z;
  float radius = max(normal.w * spreadBy(centre.xyz), 0.5 * thinnest * pixel * depth);
  vec4 inView = viewMatrix * vec4(centre.xyz + rim * radius * out_, 1.0);
  at = inView.xyz;
  around = mat3(viewMatrix) * (corner.w == 0.0 ? out_ : corner.w * tangent.xyz);
  value = centre.w;
  arc = tangent.w;
  gl_Position = projectionMatrix * inView;
}
`,eA=`
${ta}
uniform sampler2D colours;
uniform vec2 scale;
uniform float mark;
uniform float plain;
varying vec3 at;
varying vec3 around;
varying float value;
varying float arc;
void main() {
  vec3 eye = normalize(-at);
  vec3 normal = normalize(around);
  float share = clamp((value - scale.x) / (scale.y - scale.x), 0.0, 1.0);
  vec3 colour = mix(texture2D(colours, vec2((share * 255.0 + 0.5) / 256.0, 0.5)).rgb, vec3(0.55, 0.58, 0.62), plain);
  // Marks at whole lengths of the cable: they show that it moves along itself.
  float away = abs(fract(arc / mark + 0.5) - 0.5) * mark;
  float blur = fwidth(arc);
  float dark = (1.0 - smoothstep(0.02 * mark, 0.02 * mark + blur, away)) * (1.0 - smoothstep(0.05, 0.2, blur / mark));
  float edge = pow(1.0 - max(dot(normal, eye), 0.0), 3.0);
  gl_FragColor = vec4(lit(colour * (1.0 - 0.45 * dark), normal, eye, 0.12) * (1.0 - 0.35 * edge), 1.0);
}
`;function tA({first:n,last:e},t,i,s){let r=i.length,o=(a,l,c,u)=>{let d=2*Math.PI*l/Oi;t.push(a,Math.cos(d),Math.sin(d),c),i.push(u)};for(let a=n;a<=e;a++)for(let l=0;l<Oi;l++)o(a,l,0,1);for(let a=0;a<e-n;a++)for(let l=0;l<Oi;l++){let c=r+a*Oi+l,u=r+a*Oi+(l+1)%Oi;s.push(c,u,c+Oi,u,u+Oi,c+Oi)}for(let a of[-1,1]){let l=a<0?n:e,c=i.length;o(l,0,a,0);for(let u=0;u<Oi;u++)o(l,u,a,1);for(let u=0;u<Oi;u++){let d=c+1+u,h=c+1+(u+1)%Oi;s.push(c,...a<0?[h,d]:[d,h])}}}var fh=class{mesh;rings;texture;constructor(e,t){this.rings=new dh(e);let{texels:i,rows:s}=this.rings;this.texture=new Gr(i,512*3,s,ri,Ri),this.texture.magFilter=this.texture.minFilter=yn;let r=new Gr(i0(256),256,1,ri);r.magFilter=r.minFilter=Tn,r.needsUpdate=!0;let o=[],a=[],l=[];for(let d of this.rings.stretches)tA(d,o,a,l);let c=new vn;c.setAttribute("corner",new Dt(o,4)),c.setAttribute("rim",new Dt(a,1)),c.setIndex(l);let u=new ln({uniforms:{...t,rings:{value:this.texture},colours:{value:r},scale:{value:new Je(0,1)},thinnest:{value:2},mark:{value:1},plain:{value:1}},vertexShader:QE,fragmentShader:eA,side:Ji});this.mesh=new Ft(c,u),this.mesh.frustumCulled=!1}update(e,t){this.rings.update(e,t),this.texture.needsUpdate=!0}scale(e){let t=this.mesh.material.uniforms;t.plain.value=e?0:1,e&&t.scale.value.set(e.low,e.high)}marks(e){this.mesh.material.uniforms.mark.value=e}centre(e){let t=12*e,i=this.rings.texels;return new z(i[t],i[t+1],i[t+2])}dispose(){this.texture.dispose(),this.mesh.material.uniforms.colours.value.dispose(),this.mesh.material.dispose(),this.mesh.geometry.dispose()}};var nA=`
${ea}
attribute vec3 offset;
attribute vec3 side;
attribute float widen;
varying vec3 at;
varying vec3 around;
void main() {
  float by = spreadBy(position);
  vec4 inView = viewMatrix * modelMatrix * vec4(position + by * offset + max(1.0, by * widen) * side, 1.0);
  at = inView.xyz;
  around = normalMatrix * normal;
  gl_Position = projectionMatrix * inView;
}
`,iA=`
${ta}
uniform vec3 colour;
uniform float opacity;
varying vec3 at;
varying vec3 around;
void main() {
  vec3 eye = normalize(-at);
#ifdef SMOOTH
  vec3 normal = normalize(around);
#else
  vec3 normal = normalize(cross(dFdx(at), dFdy(at)));
#endif
  float facing = dot(normal, eye);
  if (facing < 0.0) normal = -normal;
  float edge = pow(1.0 - abs(facing), 2.0);
  gl_FragColor = vec4(lit(colour, normal, eye, 0.08), opacity < 1.0 ? mix(opacity, min(1.0, 3.5 * opacity), edge) : 1.0);
}
`;function gs(n){let{r:e,g:t,b:i}=new xt(n).convertLinearToSRGB();return new z(e,t,i)}function X_(n,e){let t=(e.opacity??1)<1;return new ln({uniforms:{...n,colour:{value:gs(e.colour)},opacity:{value:e.opacity??1}},vertexShader:nA,fragmentShader:iA,defines:e.smooth?{SMOOTH:""}:{},transparent:t,depthWrite:!t,depthTest:!e.onTop,side:ui})}function yt(n,e){let t=n?.[e];return Array.isArray(t)?t.map(i=>typeof i=="number"&&Number.isFinite(i)?i:null):null}function pr(n,e){let t=n?.[e];return Array.isArray(t)?t.map(i=>String(i??"")):[]}function sn(n){return!!n&&n.some(e=>e!=null)}var sA={pull:"Tension in the cable",attachment:"Tension at eye or net",sidewall:"Sidewall pressure",bend_radius:"Bend radius of the cable",rope_bend:"Bend of the rope, over its diameter",roller_steady:"Roller load, steady",roller_peak:"Roller load, peak",rope:"Pull of the rope",winch:"Pull of the winch",push:"Force of a conveyor",buckling:"Push, against buckling",squeeze:"Clamp of a conveyor",run_away:"Brake that is missing",alpha:"Overload factor",trip:"Trip of the winch",speed:"Speed of the pull",jam_ratio:"Jam ratio",clearance:"Clearance in the duct",fill:"Fill of the duct",weight_correction:"Weight correction factor",restart:"Restart from rest"};function Bn(n){let e=sA[n]??n.replaceAll("_"," ");return e.charAt(0).toUpperCase()+e.slice(1)}function $r(n){return n.name==="clearance"?"mm":Rl(n.unit)?n.unit:"1"}function pl(n){return(n.summary.limits??[]).filter(t=>t.ok!==null&&t.margin!==null).sort((t,i)=>(t.margin??0)-(i.margin??0))}function mr(n,e){return n.summary.limits?.find(t=>t.name===e)??null}function Yr(n,...e){return e.flatMap(t=>{let i=mr(n,t)?.limit;return typeof i=="number"?[{label:`allowed (${Bn(t).toLowerCase()})`,value:i}]:[]})}function q_(n){return(n.summary.events??[]).map(e=>({x:e.time_s,label:e.what}))}function $_(n){let{from_s:e,to_s:t}=n.summary.steady_window??{};return typeof e=="number"&&typeof t=="number"&&t>e?{from:e,to:t,label:"steady window"}:void 0}function Y_(n){return n.remedy??""}function ml(n){let e=n.summary.verdict??"";return e.startsWith("NOT TRUSTED")?"untrusted":e.startsWith("NOT SAFE")?"unsafe":e.startsWith("SAFE ONLY IF")?"conditional":e.startsWith("SAFE")?"safe":"unjudged"}function sp(n){return n.summary.title||n.summary.case||n.label}var Z_=6;function gl(n,e,t,i=0){let s=new Xn().setFromUnitVectors(new z(0,1,0),new z(...Lt(t,[0,1,0])));return n.translate(0,i,0),n.applyMatrix4(new Gt().makeRotationFromQuaternion(s)),n.translate(...e)}function K_(n,e,t){let i=e.at(n.center_m),{radius_m:s,width_m:r}=n,o=n.barrel_radius_m??.6*s,a=gl(new Is(.985*o,.985*o,r,48),i,n.axis),l=[new Ft(a,t("drum"))];for(let c of[-.5,.5]){let u=new Is(s,s,.02*s,64),d=new Ft(gl(u,i,n.axis,c*(r+.02*s)),t("drum",{opacity:.3}));d.renderOrder=1,l.push(d)}return l}function J_(n,e,t){let{radius_m:i,width_m:s}=n,r=new Ki,o=t("frame");for(let a of[-1,1])for(let l=0;l<Z_;l++){let c=new hs(.05*i,.02*i,.97*i).translate(0,0,.485*i);c.rotateY(2*Math.PI*l/Z_),r.add(new Ft(gl(c,[0,0,0],n.axis,a*(.5*s+.03*i)),o))}return r.position.set(...e.at(n.center_m)),r}function j_(n,e){let t=n.geometry?.reel,i=yt(n.series,"time_s")?.map(c=>c??NaN),s=yt(n.series,"reel_speed_rad_per_s");if(!t||!i||!s||!e.path)return null;let r=vt(e.path.at(e.path.from),e.at(t.center_m)),o=Math.sign(zn(bi(Lt(t.axis),r),e.path.tangent(e.path.from)))||1,a=0,l=i.map((c,u)=>(u>0&&(a+=.5*((s[u]??0)+(s[u-1]??0))*(c-i[u-1])),o*a));return c=>ys(i,l,c)??0}function Q_(n,e,t){let[i,s,r]=e.at(n.position_m),o=Lt([n.direction[0],n.direction[1],0],[1,0,0]),a=[-o[1],o[0],0],l=new Xn().setFromUnitVectors(new z(0,1,0),new z(...a)),c=new hs(1.1,.9,.5).applyMatrix4(new Gt().makeRotationFromQuaternion(l));c.translate(i+.45*o[0],s+.45*o[1],r-.65);let u=gl(new Is(.25,.25,.6,32),[i+.3*o[0],s+.3*o[1],r-.25],a);return[new Ft(c,t("frame")),new Ft(u,t("drum"))]}function ex({obstacles:n,rollers:e},t,i){return(n??[]).flatMap(s=>{let r=e[s.roller];if(!r)return[];let o=t.at(r.position_m),a=Lt(r.axis);if(s.ring_m!==null){let d=new Ka(s.ring_m,s.edge_m??.1,32,64);return[new Ft(gl(d.rotateX(.5*Math.PI),o,a),i("obstacle",{opacity:.2}))]}let l=Lt(s.side,[0,1,0]),c=new Gt().makeBasis(new z(...a),new z(...l),new z(...bi(a,l))),u=new hs(...s.size_m).applyMatrix4(c).translate(...o);return[new Ft(u,i("obstacle"))]})}function rA(n,e){let t=[0,1,0];return n.map((i,s)=>{let r=Lt(vt(n[Math.min(n.length-1,s+1)],n[Math.max(0,s-1)])),o=bi(e[s],r);return t=ni(o)>.05?Lt(o):Lt(Bt(t,r,-zn(t,r)),t),{left:t,above:bi(r,t)}})}function tx({line:n,base:e,profile:t,closed:i,ups:s,widen:r=0}){let o=[],a=[],l=[],c=[],u=[],d=rA(n,s),h=t.length;n.forEach((p,v)=>{let{left:g,above:m}=d[v],S=zn(vt(p,e[v]),m),A=Bt(p,m,-S);for(let{across:b,above:C,wide:T=0}of t)o.push(...A),a.push(...Bt(Bt([0,0,0],g,b),m,S+C)),l.push(...Bt([0,0,0],g,T)),c.push(...Lt(Bt(Bt([0,0,0],g,b),m,C),m));if(v!==0)for(let b=0;b<(i?h:h-1);b++){let C=(v-1)*h+b,T=(v-1)*h+(b+1)%h;u.push(C,T,C+h,T,T+h,C+h)}});let f=new vn;return f.setAttribute("position",new Dt(o,3)),f.setAttribute("offset",new Dt(a,3)),f.setAttribute("side",new Dt(l,3)),f.setAttribute("normal",new Dt(c,3)),f.setAttribute("widen",new Dt(new Float32Array(o.length/3).fill(r),1)),f.setIndex(u),f}var nx=(n,e)=>Array.from({length:e},(t,i)=>{let s=2*Math.PI*i/e;return{across:n*Math.cos(s),above:n*Math.sin(s)}}),ix=(n,e,t,i)=>[{across:n,above:t},{across:n+e,above:t},{across:n+e,above:i},{across:n,above:i}];function sx(n,e,t){let i={line:n.slice(0,1),ups:e.slice(0,1)};for(let s=1;s<n.length;s++){let[r,o]=[n[s-1],n[s]],a=Math.min(400,Math.max(1,Math.ceil(ni(vt(o,r))/t)));for(let l=1;l<=a;l++)i.line.push(Bt(r,vt(o,r),l/a)),i.ups.push(Bt(e[s-1],vt(e[s],e[s-1]),l/a))}return i}var oA=28,rx=1,aA=1.8,ox=.6,ph={width:.1,height:.22},mh=class{constructor(e,t,i){this.model=e;this.shared=t;let s=e.run.geometry;if(this.angle=j_(e.run,e),!s)return;this.route(i);for(let a of s.surfaces)this.surface(a);for(let a of s.conveyors)this.conveyor(a);let r=(a,l={})=>this.paint(a,l),o=[...s.reel?K_(s.reel,e,r):[],...s.winch?Q_(s.winch,e,r):[],...ex(s,e,r)];for(let a of o)this.group.add(a);s.reel&&this.group.add(this.spokes=J_(s.reel,e,r))}model;shared;group=new Ki;cast=null;spokes=null;angle;painted=[];turn(e){let t=this.model.run.geometry?.reel?.axis;!t||!this.angle||this.spokes?.quaternion.setFromAxisAngle(new z(...Lt(t,[0,1,0])),this.angle(e))}paint(e,t){let i=X_(this.shared,{colour:"#888888",...t});return this.painted.push({material:i,part:e}),i}route(e){let t=this.model.path?.points??[],i=(s,r,o)=>{let a=new vn;a.setAttribute("position",new Dt(s.flat(),3));let l=new Wo({transparent:!0,opacity:o});this.painted.push({material:l,part:r});let c=new Xo(a,l);return this.group.add(c),c};i(t,"route",.7),this.cast=i(t.map(([s,r])=>[s,r,e]),"grid",.4)}swept(e,t,i,s,r=0){let{line:o,ups:a}=sx(e,s?.length===e.length?s:e.map(()=>[0,0,1]),rx),l=this.model.path,c=o.map(u=>{let d=l?.nearest(u);return l&&d&&d.distance<3?l.at(d.s):u});return tx({line:o,base:c,profile:t,closed:i,ups:a,widen:r})}surface(e){let t=e.points_m.map(this.model.at);if(t.length<2)return;let i=e.kind==="duct"&&e.diameter_m,s=i?this.swept(t,nx(.5*i,oA),!0,e.up):this.swept(t,lA(e),!1,e.up??t.map(()=>e.normal??[0,0,1]),this.widening(e)),r=i?this.paint("duct",{opacity:.13,smooth:!0}):this.paint("floor",{opacity:.55}),o=new Ft(s,r);o.renderOrder=i?2:1,this.group.add(o)}widening(e){return aA*this.model.diameter/(e.width_m??ox)}conveyor(e){let{path:t,at:i}=this.model,{from_m:s,to_m:r}=e,o=Math.max(2,Math.ceil((r-s)/rx)+1),a=t?Array.from({length:o},(c,u)=>t.at(s+(r-s)*u/(o-1))):e.points_m.map(i);if(a.length<2)return;let l=.5*this.model.diameter;for(let c of[l,-l-ph.width]){let u=ix(c,ph.width,-.5*ph.height,.5*ph.height);this.group.add(new Ft(this.swept(a,u,!0),this.paint("belt",{})))}}shadow(e){this.cast&&(this.cast.visible=e)}recolour(e){for(let{material:t,part:i}of this.painted)t instanceof ln?t.uniforms.colour.value=gs(e[i]):t.color.set(e[i])}dispose(){this.group.traverse(e=>{(e instanceof Ft||e instanceof Xo)&&e.geometry.dispose()});for(let{material:e}of this.painted)e.dispose()}};function lA({width_m:n,height_m:e,section:t}){let i=.5*(n??ox),s=e??0;return t==="v"?[-i,0,i].map(r=>({across:r,above:s*Math.abs(r)/i})):s>0?[{across:-i,above:s},{across:-i,above:0},{across:i,above:0},{across:i,above:s}]:[i,-i].map(r=>({across:0,above:0,wide:r}))}function rp(n){let e=n.reduce((i,s)=>Math.min(i,s[2]),1/0),t=i=>{let s=n.map(r=>r[i]);return s.reduce((r,o)=>Math.max(r,o),-1/0)-s.reduce((r,o)=>Math.min(r,o),1/0)};return Number.isFinite(e)?e-Math.max(1,.008*Math.hypot(t(0),t(1))):-1}var cA=`
varying vec2 place;
void main() {
  place = position.xy;
  gl_Position = projectionMatrix * viewMatrix * modelMatrix * vec4(position, 1.0);
}
`,uA=`
uniform vec3 colour;
uniform float spacing;
uniform vec3 focus;
varying vec2 place;
float lines(float apart) {
  vec2 at = place / apart;
  vec2 blur = fwidth(at);
  vec2 near = abs(fract(at - 0.5) - 0.5) / blur;
  return (1.0 - min(min(near.x, near.y), 1.0)) * (1.0 - smoothstep(0.15, 0.5, max(blur.x, blur.y)));
}
void main() {
  float fade = 1.0 - smoothstep(0.35, 1.0, distance(place, focus.xy) / focus.z);
  float strength = max(0.35 * lines(spacing), 0.8 * lines(5.0 * spacing));
  gl_FragColor = vec4(colour, strength * fade);
}
`,gh=class{mesh;spacing=1;constructor(e,t){let i=new ln({uniforms:{colour:{value:gs("#888")},spacing:{value:1},focus:{value:new z(0,0,t)}},vertexShader:cA,fragmentShader:uA,transparent:!0,depthWrite:!1,side:ui});this.mesh=new Ft(new Hr(2*t,2*t),i),this.mesh.position.z=e,this.mesh.renderOrder=-1}follow(e,t,i,s){let r=i/14/s,o=10**Math.floor(Math.log10(r));this.spacing=s*o*(r/o>5?10:r/o>2?5:2);let a=this.mesh.material.uniforms;a.spacing.value=this.spacing,a.focus.value.set(e,t,1.6*i)}recolour(e){this.mesh.material.uniforms.colour.value=gs(e)}dispose(){this.mesh.geometry.dispose(),this.mesh.material.dispose()}};var Zr=n=>({x:new Float32Array(n),y:new Float32Array(n),depth:new Float32Array(n)});function na(n,e,t,i,s){let r=c=>[e[c],e[c+4],e[c+8],e[c+12]],[o,a,l]=[r(0),r(1),r(3)];for(let c=0;c<s.x.length;c++){let u=n[3*c],d=n[3*c+1],h=n[3*c+2],f=l[0]*u+l[1]*d+l[2]*h+l[3];s.depth[c]=f,s.x[c]=(.5+.5*(o[0]*u+o[1]*d+o[2]*h+o[3])/f)*t,s.y[c]=(.5-.5*(a[0]*u+a[1]*d+a[2]*h+a[3])/f)*i}}function ax(n,e,t,i){let s=-1,r=1/0;for(let o=0;o<n.x.length;o++){let a=n.depth[o];if(a<=0)continue;let c=Math.hypot(n.x[o]-e,n.y[o]-t)/i(a);c<1&&c*(.2+a)<r&&(r=c*(.2+a),s=o)}return s}function lx(n,e,t,i){let s=null;for(let r=0;r+1<n.x.length;r++){if(n.depth[r]<=0||n.depth[r+1]<=0)continue;let o=n.x[r+1]-n.x[r],a=n.y[r+1]-n.y[r],l=o*o+a*a,c=l>0?((e-n.x[r])*o+(t-n.y[r])*a)/l:0,u=Math.min(1,Math.max(0,c)),d=Math.hypot(n.x[r]+u*o-e,n.y[r]+u*a-t);d<=i&&(!s||d<s.pixels)&&(s={index:r+u,pixels:d})}return s}function hA(n){let e=n.map((s,r)=>r).sort((s,r)=>n[r].weight-n[s].weight),t=[],i=new Array(n.length).fill(!1);for(let s of e){let r=n[s];!t.every(a=>Math.abs(r.x-a.x)*2>=r.width+a.width||Math.abs(r.y-a.y)*2>=r.height+a.height)&&r.weight<100||(i[s]=!0,t.push(r))}return i}var cx=6.6,dA=20,ux=16,_h=class{root=P("div",{class:"view-labels","aria-hidden":"true"});elements=new Map;screen=Zr(0);points=new Float32Array(0);set(e,t){let i=this.elements.get(e);if(!t){i?.element.remove(),this.elements.delete(e);return}if(i&&i.label.text===t.text&&i.label.kind===t.kind){i.label=t;return}let s=i?.element??P("span");s.className=`view-label view-label-${t.kind}`,s.replaceChildren(P("b",{},t.text),P("i")),i||this.root.append(s),this.elements.set(e,{element:s,label:t})}shown(){return[...this.elements.values()].flatMap(({element:e,label:t},i)=>e.hidden?[]:[{text:t.text,x:this.screen.x[i],y:this.screen.y[i],aside:parseFloat(e.style.getPropertyValue("--aside"))||0}])}update(e,t,i){let s=[...this.elements.values()];this.screen.x.length!==s.length&&(this.screen=Zr(s.length),this.points=new Float32Array(3*s.length)),s.forEach(({label:u},d)=>this.points.set(u.point,3*d)),na(this.points,e.elements,t,i,this.screen);let{x:r,y:o,depth:a}=this.screen,l=s.map((u,d)=>a[d]>0&&r[d]>0&&r[d]<t&&o[d]>ux&&o[d]<i),c=hA(s.map(({label:u},d)=>({x:l[d]?r[d]:-1e6*(d+1),y:l[d]?o[d]-ux:0,width:cx*u.text.length+14,height:dA,weight:u.weight})));s.forEach(({element:u},d)=>{let h=l[d]&&c[d];if(u.hidden=!h,!h)return;let f=.5*(cx*s[d].label.text.length+14),p=Math.min(Math.max(r[d],f),t-f);u.style.setProperty("--aside",`${(p-r[d]).toFixed(0)}px`),u.style.transform=`translate(${r[d].toFixed(1)}px, ${o[d].toFixed(1)}px)`})}};var hx={light:{ground:"#f4f6f8",grid:"#9aa7b4",route:"#5c6b7a",duct:"#4a78a8",floor:"#b9b1a2",belt:"#3f5f68",steel:"#b3bdc7",drum:"#b98d5e",frame:"#59636e",obstacle:"#b0532f"},dark:{ground:"#12171d",grid:"#465362",route:"#8796a6",duct:"#7fb0e6",floor:"#5b574f",belt:"#6f97a2",steel:"#6b7783",drum:"#a87f54",frame:"#98a4b0",obstacle:"#d9774f"}};var fA=.1,pA=.4,mA=2,gA=2.2,_A=.42,xA=`
${ea}
uniform float widest;      // exaggerated widths end at this times the exaggeration, m
attribute vec3 base;
attribute vec4 away;       // direction from the route to the roller, and the gap between route and the roller's surface, m
attribute vec3 axis;
attribute vec4 measure;    // radius, width, largest drawn radius, m; number
varying vec3 at;
varying vec3 around;
varying float number;
void main() {
  float by = spreadBy(base);
  float radius = max(measure.x, min(by * measure.x, measure.z));
  vec3 centre = base + away.xyz * (by * away.w + radius);
  vec3 across = normalize(abs(axis.z) > 0.9 ? cross(axis, vec3(1.0, 0.0, 0.0)) : cross(axis, vec3(0.0, 0.0, 1.0)));
  mat3 turn = mat3(across, axis, cross(across, axis));
  vec3 corner = turn * (position * vec3(radius, max(measure.y, min(by * measure.y, by * widest)), radius));
  vec4 inView = viewMatrix * vec4(centre + corner, 1.0);
  at = inView.xyz;
  around = mat3(viewMatrix) * (turn * normal);
  number = measure.w;
  gl_Position = projectionMatrix * inView;
}
`,yA=`
${ta}
uniform vec3 colour;
uniform vec3 pickedColour;
uniform float picked;
uniform float hovered;
varying vec3 at;
varying vec3 around;
varying float number;
void main() {
  vec3 own = abs(number - picked) < 0.5 ? pickedColour : abs(number - hovered) < 0.5 ? mix(colour, pickedColour, 0.55) : colour;
  gl_FragColor = vec4(lit(own, normalize(around), normalize(-at), 0.15), 1.0);
}
`,dx=({kind:n})=>n!=="box"&&n!=="bell-mouth";function vA(n,e,t){let i=n?.nearest(e);if(!n||!i||i.distance>mA||i.distance<1e-6)return{base:e,away:[0,0,-1],gap:-t};let s=n.at(i.s);return{base:s,away:Lt(vt(e,s)),gap:i.distance-t}}var xh=class{mesh;centres;stand;constructor(e,{at:t,path:i,diameter:s},r){let o=bA(e);this.stand=e.map(d=>{let h=dx(d)?d.radius_m??fA:0;return{...vA(i,t(d.position_m),h),radius:h,largest:h>0?_A*o:0}}),this.centres=new Float32Array(3*e.length);let a=new Is(1,1,1,20),l=new el;l.index=a.index,l.setAttribute("position",a.getAttribute("position")),l.setAttribute("normal",a.getAttribute("normal"));let c=(d,h,f)=>{let p=new Float32Array(h*e.length);e.forEach((v,g)=>p.set(f(v,g),h*g)),l.setAttribute(d,new qa(p,h))};c("base",3,(d,h)=>this.stand[h].base),c("away",4,(d,h)=>[...this.stand[h].away,this.stand[h].gap]),c("axis",3,d=>Lt(d.axis,[0,1,0])),c("measure",4,(d,h)=>[this.stand[h].radius,dx(d)?d.width_m??pA:0,this.stand[h].largest,h]),l.instanceCount=e.length;let u=new ln({uniforms:{...r,widest:{value:gA*s},colour:{value:gs("#8d99a6")},pickedColour:{value:gs("#e8590c")},picked:{value:-1},hovered:{value:-1}},vertexShader:xA,fragmentShader:yA});this.mesh=new Ft(l,u),this.mesh.frustumCulled=!1,this.place(1)}place(e){this.stand.forEach(({base:t,away:i,gap:s,radius:r,largest:o},a)=>{let l=Math.max(r,Math.min(e*r,o));this.centres.set(Bt(t,i,e*s+l),3*a)})}centre(e){return[this.centres[3*e],this.centres[3*e+1],this.centres[3*e+2]]}drawnRadius(e,t){let{radius:i,largest:s}=this.stand[e];return Math.max(i,Math.min(t*i,s))}mark(e,t){this.mesh.material.uniforms.picked.value=e,this.mesh.material.uniforms.hovered.value=t}recolour(e){this.mesh.material.uniforms.colour.value=gs(e)}dispose(){this.mesh.geometry.dispose(),this.mesh.material.dispose()}};function bA(n){let e=n.map(s=>s.s_m).filter(s=>s!==null);e.sort((s,r)=>s-r);let i=e.slice(1).map((s,r)=>s-e[r]).filter(s=>s>.001).sort((s,r)=>s-r);return i[Math.floor(i.length/2)]??1/0}var fx={type:"change"},ap={type:"start"},mx={type:"end"},yh=new zr,px=new Ui,MA=Math.cos(70*Uf.DEG2RAD),Cn=new z,hi=2*Math.PI,Ht={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},op=1e-6,vh=class extends tl{constructor(e,t=null){super(e,t),this.state=Ht.NONE,this.target=new z,this.cursor=new z,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:ar.ROTATE,MIDDLE:ar.DOLLY,RIGHT:ar.PAN},this.touches={ONE:lr.ROTATE,TWO:lr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new z,this._lastQuaternion=new Xn,this._lastTargetPosition=new z,this._quat=new Xn().setFromUnitVectors(e.up,new z(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new qo,this._sphericalDelta=new qo,this._scale=1,this._panOffset=new z,this._rotateStart=new Je,this._rotateEnd=new Je,this._rotateDelta=new Je,this._panStart=new Je,this._panEnd=new Je,this._panDelta=new Je,this._dollyStart=new Je,this._dollyEnd=new Je,this._dollyDelta=new Je,this._dollyDirection=new z,this._mouse=new Je,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=wA.bind(this),this._onPointerDown=SA.bind(this),this._onPointerUp=TA.bind(this),this._onContextMenu=LA.bind(this),this._onMouseWheel=CA.bind(this),this._onKeyDown=RA.bind(this),this._onTouchStart=PA.bind(this),this._onTouchMove=IA.bind(this),this._onMouseDown=EA.bind(this),this._onMouseMove=AA.bind(this),this._interceptControlDown=NA.bind(this),this._interceptControlUp=DA.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction=""}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(fx),this.update(),this.state=Ht.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Cn.copy(t).sub(this.target),Cn.applyQuaternion(this._quat),this._spherical.setFromVector3(Cn),this.autoRotate&&this.state===Ht.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=hi:i>Math.PI&&(i-=hi),s<-Math.PI?s+=hi:s>Math.PI&&(s-=hi),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Cn.setFromSpherical(this._spherical),Cn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Cn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Cn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new z(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new z(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Cn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(yh.origin.copy(this.object.position),yh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(yh.direction))<MA?this.object.lookAt(this.target):(px.setFromNormalAndCoplanarPoint(this.object.up,this.target),yh.intersectPlane(px,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>op||8*(1-this._lastQuaternion.dot(this.object.quaternion))>op||this._lastTargetPosition.distanceToSquared(this.target)>op?(this.dispatchEvent(fx),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?hi/60*this.autoRotateSpeed*e:hi/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Cn.setFromMatrixColumn(t,0),Cn.multiplyScalar(-e),this._panOffset.add(Cn)}_panUp(e,t){this.screenSpacePanning===!0?Cn.setFromMatrixColumn(t,1):(Cn.setFromMatrixColumn(t,0),Cn.crossVectors(this.object.up,Cn)),Cn.multiplyScalar(e),this._panOffset.add(Cn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Cn.copy(s).sub(this.target);let r=Cn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientX),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(hi*this._rotateDelta.x/t.clientHeight),this._rotateUp(hi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(hi*this._rotateDelta.x/t.clientHeight),this._rotateUp(hi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Je,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function SA(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function wA(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function TA(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(mx),this.state=Ht.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function EA(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case ar.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ht.DOLLY;break;case ar.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ht.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ht.ROTATE}break;case ar.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ht.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ht.PAN}break;default:this.state=Ht.NONE}this.state!==Ht.NONE&&this.dispatchEvent(ap)}function AA(n){switch(this.state){case Ht.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ht.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ht.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function CA(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ht.NONE||(n.preventDefault(),this.dispatchEvent(ap),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(mx))}function RA(n){this.enabled!==!1&&this._handleKeyDown(n)}function PA(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case lr.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(n),this.state=Ht.TOUCH_ROTATE;break;case lr.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(n),this.state=Ht.TOUCH_PAN;break;default:this.state=Ht.NONE}break;case 2:switch(this.touches.TWO){case lr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ht.TOUCH_DOLLY_PAN;break;case lr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ht.TOUCH_DOLLY_ROTATE;break;default:this.state=Ht.NONE}break;default:this.state=Ht.NONE}this.state!==Ht.NONE&&this.dispatchEvent(ap)}function IA(n){switch(this._trackPointer(n),this.state){case Ht.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ht.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ht.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ht.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ht.NONE}}function LA(n){this.enabled!==!1&&n.preventDefault()}function NA(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function DA(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var FA=.7,UA=2,gx=n=>[n.x,n.y,n.z],bh=class{constructor(e,t,i){this.root=e;this.shared=t;this.still=i;this.renderer=new ch({antialias:!0,preserveDrawingBuffer:!0}),this.renderer.setPixelRatio(Math.min(UA,window.devicePixelRatio)),e.prepend(this.renderer.domElement),this.camera.up.set(0,0,1),this.controls=new vh(this.camera,this.renderer.domElement),this.controls.zoomToCursor=!0,this.controls.zoomSpeed=1.6,this.controls.addEventListener("change",()=>this.invalidate()),this.controls.addEventListener("start",()=>this.flight=null),this.observer=new ResizeObserver(()=>this.resize()),this.observer.observe(e),this.resize()}root;shared;still;scene=new Ga;camera=new Wn(35,1,.1,1e3);renderer;controls;clip=new Gt;onFrame=()=>!1;spent={update:0,render:0};flight=null;request=0;last=0;radius=100;observer;get width(){return Math.max(1,this.root.clientWidth)}get height(){return Math.max(1,this.root.clientHeight)}get aspect(){return this.width/this.height}get pose(){return{position:gx(this.camera.position),target:gx(this.controls.target),fov:this.camera.fov}}get distance(){return this.camera.position.distanceTo(this.controls.target)}resize(){this.renderer.setSize(this.width,this.height,!1),this.camera.aspect=this.aspect,this.invalidate()}reach(e){this.radius=e}go(e,t=!1){t||this.still?(this.flight=null,this.stand(e)):this.flight={from:this.pose,to:e,part:0},this.invalidate()}get goal(){return this.flight?.to??this.pose}zoom(e){let t=this.goal;this.go(wo(t,t.target,ni(vt(t.position,t.target))*e))}orbit(e,t){let{position:i,target:s,fov:r}=this.goal,o=new z(...vt(i,s)),a=Math.hypot(o.x,o.y),l=Math.atan2(o.z,a)+t*Math.PI/180,c=Math.atan2(o.y,o.x)+e*Math.PI/180,u=o.length(),d=Math.min(1.569,Math.max(-1.569,l)),h=u*Math.cos(d),f=[h*Math.cos(c),h*Math.sin(c),u*Math.sin(d)];this.go({position:[s[0]+f[0],s[1]+f[1],s[2]+f[2]],target:s,fov:r},!0)}shift(e){if(this.camera.position.add(new z(...e)),this.controls.target.add(new z(...e)),this.flight)for(let t of[this.flight.from,this.flight.to])for(let i of[t.position,t.target])i.forEach((s,r)=>i[r]=s+e[r])}stand(e){this.camera.position.set(...e.position),this.controls.target.set(...e.target),this.camera.fov=e.fov,this.controls.update()}invalidate(){this.request||=requestAnimationFrame(e=>this.frame(e))}frame(e){this.request=0;let t=this.last>0?(e-this.last)/1e3:0;if(this.flight){this.flight.part=Math.min(1,this.flight.part+Math.min(t,.1)/FA);let{from:o,to:a,part:l}=this.flight;this.stand(Fg(o,a,l)),l>=1&&(this.flight=null)}let i=performance.now();this.fit();let s=this.onFrame(t)||this.flight!==null,r=performance.now();this.renderer.render(this.scene,this.camera),this.spent={update:r-i,render:performance.now()-r},this.last=s?e:0,s&&this.invalidate()}shot(e){let{renderer:t}=this,i=t.getPixelRatio();t.setPixelRatio(e),this.fit(),this.onFrame(0),t.render(this.scene,this.camera);let s=t.domElement.toDataURL("image/png");return t.setPixelRatio(i),this.invalidate(),s}fit(){let e=this.camera,t=e.position.length()+1.5*this.radius+10;e.near=Math.max(.02*this.distance,t*2e-5,.01),e.far=t,e.updateProjectionMatrix(),e.updateMatrixWorld(),this.clip.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this.shared.pixel.value=2*Math.tan(e.fov*Math.PI/360)/this.height}dispose(){cancelAnimationFrame(this.request),this.observer.disconnect(),this.controls.dispose(),this.renderer.dispose(),this.renderer.forceContextLoss(),this.renderer.domElement.remove()}};var OA=5,kA=100,BA=55,VA=[1,2,5,10,20,50,100,200,500],zA=.5,GA=9,HA=12,Mh=class{constructor(e,t,i,s){this.model=t;this.beside=s;this.stage=new bh(e,this.shared,i),e.append(this.labels.root);let{run:r,path:o,extent:a}=t,l=this.wide=a.reduce((f,p)=>Math.max(f,ni(p)),10),c=rp(a);this.ground=new gh(c,6*l),this.equipment=new mh(t,this.shared,c+.001),this.chains=[t,...s.models].map(({chain:f})=>f?new fh(f,this.shared):null);let u=r.geometry?.rollers??[];this.rollers=u.length>0?new xh(u,t,this.shared):null;let d=r.geometry?.reel;d&&(this.shared.reel.value.set(...t.at(d.center_m),d.radius_m),this.shared.reelAxis.value.set(...Ld(d.axis)));let{scene:h}=this.stage;h.add(this.ground.mesh,this.equipment.group),this.rollers&&h.add(this.rollers.mesh);for(let f of this.chains)f&&(f.mesh.visible=!1,h.add(f.mesh));this.stage.reach(6*l),this.routePoints=Float32Array.from((o?.points??[]).flat()),this.routeScreen=Zr(o?.points.length??0),this.rollerScreen=Zr(u.length)}model;beside;stage;labels=new _h;chains;rollers;ground;shared=W_();equipment;routePoints;routeScreen;rollerScreen;wide;unit=1;asked=null;get factor(){return this.shared.factor.value}exaggerate(e){this.asked=e,this.stage.invalidate()}paint(e){let t=hx[e];this.stage.renderer.setClearColor(t.ground),this.equipment.recolour(t),this.rollers?.recolour(t.steel),this.ground.recolour(t.grid),this.shared.light.value.set(e==="dark"?.6:.68,.42),this.stage.invalidate()}scale(e){for(let t of this.chains)t?.scale(e);this.stage.invalidate()}update(e){let{stage:t}=this,i=this.shared.pixel.value*t.distance,s=Math.min(kA,Math.max(1,OA*i/this.model.diameter)),r=this.beside.models.length>0?1:s;this.shared.factor.value=this.asked??r;let{target:o}=t.controls;this.ground.follow(o.x,o.y,t.distance,this.unit),this.ground.mesh.position.z=this.groundHeight(),this.equipment.shadow(t.distance>zA*this.wide);let a=VA.find(l=>l/i>BA)??1e3;for(let l of this.chains)l?.marks(a);e&&this.equipment.turn(e.time),e&&[e,...this.beside.nows].forEach((l,c)=>{let u=this.chains[c];!l||!u||(u.update(l.centres,l.values),u.mesh.visible=!0)})}groundHeight(){let{target:e}=this.stage.controls,t=2*this.stage.distance,i=this.model.extent.filter(([s,r])=>Math.hypot(s-e.x,r-e.y)<t);return rp(i.length>0?i:this.model.extent)}updateLabels(){this.labels.update(this.stage.clip,this.stage.width,this.stage.height)}rollerAt(e,t){let i=this.rollers;if(!i)return-1;let{stage:s,factor:r}=this;i.place(r),na(i.centres,s.clip.elements,s.width,s.height,this.rollerScreen);let o=this.shared.pixel.value,a=i.drawnRadius(0,r);return ax(this.rollerScreen,e,t,l=>Math.max(GA,a/(o*l)))}placeAt(e,t){let{stage:i,model:s}=this;if(!s.path)return null;na(this.routePoints,i.clip.elements,i.width,i.height,this.routeScreen);let r=.5*s.diameter*this.factor/(this.shared.pixel.value*i.distance),o=lx(this.routeScreen,e,t,Math.max(HA,1.2*r));if(!o)return null;let a=Math.min(s.path.points.length-2,Math.floor(o.index)),{s:l}=s.path;return l[a]+(o.index-a)*(l[a+1]-l[a])}onScreen(e){let t=Zr(1);return na(e,this.stage.clip.elements,this.stage.width,this.stage.height,t),{x:t.x[0],y:t.y[0]}}dispose(){for(let e of this.chains)e?.dispose();this.rollers?.dispose(),this.equipment.dispose(),this.ground.dispose(),this.labels.root.remove(),this.stage.dispose()}};var WA="This browser does not draw in three dimensions here (no WebGL). Times and figures below still work, and everything is in the figures of this page.",XA="These results hold no states (results.h5), so nothing moves.";function qA(){let n=Hg.flatMap(([t,i])=>[P("span",{},P("kbd",{},t),` ${i}`)," "]);return P("details",{class:"view-help"},P("summary",{},"Space plays, \u2190 \u2192 step, + \u2212 zoom, 1\u20139 move the camera, F follows the head; all keys and the mouse"),P("p",{},"Drag turns, the right button moves, the wheel zooms once the picture has been clicked. A click on a roller or the cable shows its figures over time, a double click goes there."),P("p",{},...n))}function $A(n,e){let t=window.matchMedia("(prefers-reduced-motion: reduce)").matches;try{return new Mh(n,e.model,t,e.beside)}catch(i){return console.info(i),n.classList.add("view-stage-empty"),n.prepend(P("p",{class:"view-notice",role:"note"},WA)),null}}function YA(n,e,t){let i=n.stage.renderer.domElement,s=-1,r=o=>{if(o===s)return;s=o;let a=t.get("roller")??-1;n.rollers?.mark(a,o),e.hover(o)};return Jg(i,{hover:(o,a)=>{let l=n.rollerAt(o,a);r(l);let c=l>=0?e.model.run.geometry?.rollers[l]?.s_m??null:n.placeAt(o,a);i.style.cursor=l>=0||c!==null?"pointer":"",t.set("place",c)},leave:()=>{r(-1),t.set("place",null)},click:(o,a)=>{i.focus({preventScroll:!0});let l=n.rollerAt(o,a),c=n.placeAt(o,a);e.inspect(l>=0?{roller:l}:c!==null?{place:c}:null)},double:(o,a)=>{e.toPlace(n.placeAt(o,a))}})}function Sh(n,e,t,i=[]){let s=P("p"),r=P("p",{class:"view-spoken","aria-live":"polite"}),o=new mc(e,t,new sc(s,r),i),a=P("div",{class:"view-stage"}),l=P("div",{class:"view3d",role:"group","aria-label":"The pull in three dimensions"},o.tools.root,a,o.player.root,P("div",{class:"view-words"},s,r,qA()));n.replaceChildren(l);let c=[],u=$A(a,o);if(u){o.draws(u,new ec(u,()=>o.now,()=>o.playback.time)),a.append(o.legend.root,o.inspector.root);let f=u.stage.renderer.domElement;f.tabIndex=0,f.setAttribute("role","img"),f.setAttribute("aria-label","Route, rollers and cable; keys and a sentence on what is to be seen are below"),u.stage.controls.enableZoom=!1,f.addEventListener("focus",()=>u.stage.controls.enableZoom=!0),f.addEventListener("blur",()=>u.stage.controls.enableZoom=!1),c.push(YA(u,o,t))}let d=()=>{l.dataset.theme=t.get("theme"),o.redress()};return c.push(Wg(l,o),t.subscribe("units",d),t.subscribe("theme",d),t.subscribe("place",()=>o.mark()),t.subscribe("time",(f,p)=>{p!==o&&f!==null&&o.showAt(f)}),t.subscribe("roller",(f,p)=>{p!==o&&o.inspect(f===null?null:{roller:f})})),d(),o.preset(0,!0),{ready:ZA(e,o,s),viewer:o,onPaper:()=>Kg(o,t),dispose:()=>{c.forEach(f=>f()),o.dispose(),n.replaceChildren()}}}async function ZA(n,e,t){if(!n.states||n.states.frames===0){t.textContent=XA;return}t.textContent="Unpacking the states\u2026";try{await Cd(n.states,(i,s)=>e.arrived(i,s));for(let[i,{states:s}]of e.beside.runs.entries())s&&s.frames>0&&await Cd(s,r=>e.besideArrived(i,r));e.forces=await qg(n),e.inspectAgain()}catch(i){t.textContent=`The states cannot be shown: ${i instanceof Error?i.message:String(i)}.`}}var KA=600,JA=4e6,jA=.25,QA=1e3,lp={position:{components:3,unit:"m",step:.001},tension:{components:1,unit:"N",step:1}},eC=n=>Number.isFinite(n)?n:null,wh=class{constructor(e,t){this.name=e;this.row=t}name;row;q=new Int32Array(0);put(e,t){if((e+1)*this.row>this.q.length){let r=new Int32Array(2*(e+1)*this.row);r.set(this.q),this.q=r}let{step:i}=lp[this.name],s=e*this.row;for(let r=0;r<this.row;r++)this.q[s+r]=Math.round(t[r]/i)}move(e,t){this.q.copyWithin(t*this.row,e*this.row,(e+1)*this.row)}};function _x(n,e,t,i){let s=e.runs[0];if(!s)throw new Error("There is no run.");Hh(s);let r=s.chain?.segments??0;s.states={frames:0,segments:r,time_s:[],head_at_m:[],fields:lp,packed:{position:"",tension:""}},document.documentElement.dataset.theme=i;let o=new Mo({place:null,time:null,units:t,theme:i,run:0,roller:null}),a=P("div",{class:"view"}),l=P("div",{class:"live-figure"});n.replaceChildren(l,a);let c=Sh(a,s,o),u={zoom:null,hidden:new Set,open:!1},d=[],h=[new wh("position",3*r),new wh("tension",r)],f=Math.max(20,Math.min(KA,Math.floor(JA/Math.max(1,4*r)))),p=1,v=0,g=null,m=-1/0;function S(){let N=d.map(U=>U.time),y=(U,k,X)=>({label:U,role:k,x:N,y:d.map(O=>eC(X(O)))}),E=g;E?.element.removeAttribute("id"),g=new bo({id:"live",title:"Force at the winch so far",caption:"Forces of the run that is being computed, and what theory expects.",along:"time",xLabel:"time",yLabel:"force",yUnit:"N",fromZero:!0,curves:[y("winch","simulated",U=>U.force),y("largest tension anywhere","second",U=>U.most),y("expected by theory","theory",U=>U.reference)].filter(U=>U.y.some(k=>k!==null))},o,u);let{element:F}=g;l.append(F);let I=()=>{if(!F.querySelector("canvas"))return void requestAnimationFrame(I);E?.dispose(),l.replaceChildren(F)};I()}let A=-1/0,b=!1;function C(){let N=performance.now();if(b||N<A||r===0)return;b=!0;let y=new Ir(d.map(E=>E.time),r);for(let{name:E,q:F}of h){let I=lp[E];y.fields.set(E,{meta:I,q:F.subarray(0,d.length*r*I.components)})}c.viewer.grown(y),requestAnimationFrame(()=>setTimeout(()=>{b=!1;let E=performance.now();A=E+(E-N)*(1/jA-1)}))}function T({position:N,tension:y,...E}){let F=d[d.length-1];if(F&&E.time<F.time&&(d=[]),F&&E.time===F.time&&d.pop(),!(v++%p!==0||N.length!==3*r)&&(h.forEach(I=>I.put(d.length,I.name==="position"?N:y)),d.push(E),!(d.length<=f))){d=d.filter((I,U)=>U%2===0);for(let I of h)d.forEach((U,k)=>I.move(2*k,k));p*=2}}return{add(N){T(N),C();let y=performance.now();y-m<QA||l.children.length>1||l.contains(document.activeElement)||(m=y,S())}}}var ia={along:"place",xLabel:"place along the route"};function _l(n,e){let t=n.map((i,s)=>s).filter(i=>n[i]!==null);return t.sort((i,s)=>n[i]-n[s]),{x:t.map(i=>n[i]??null),y:t.map(i=>e[i]??null)}}function tC(n,e,t){return n.some((i,s)=>Math.abs((i??NaN)-(e[s]??NaN))>t*Math.abs(i??0))}function nC(n){let e=n.theory_along,t=yt(n.stations,"s_m")??[],i=[],s=(a,l,c,u)=>{let d=u?yt(n.stations,u):null;e&&sn(c)?i.push({label:a,role:l,..._l(e.s_m,c)}):sn(d)&&i.push({label:a,role:l,..._l(t,d)})},r=e?.forward_N,o=e&&sn(e.run_N)?e.run_N:void 0;return s("reference theory","theory",o??r,"reference_N"),o&&sn(r)&&tC(o,r,.005)&&s("theory, the whole route full of cable","third",r,null),s("theory, pulled the other way","backward",e?.backward_N,null),s("piece formulas (eq. 3-10)","paper",e?.paper_N,"paper_N"),i}function xl(n){let e=n.envelope?.place,t=yt(n.stations,"s_m")??[],i=[],s;e&&sn(e.tension_min_N)&&sn(e.tension_max_N)&&(i.push({label:"simulated, least",role:"envelope",x:e.s_m,y:e.tension_min_N,quiet:!0}),i.push({label:"simulated, largest",role:"envelope",x:e.s_m,y:e.tension_max_N,quiet:!0}),s={low:0,high:1,label:"simulated, least to largest of the run"});let r=yt(n.stations,"mean_N");sn(r)?i.push({label:"simulated, steady mean",role:"simulated",..._l(t,r)}):e&&sn(e.tension_mean_N)&&i.push({label:"simulated, mean of the run",role:"simulated",x:e.s_m,y:e.tension_mean_N});let o=yt(n.stations,"peak_N");if(!s&&sn(o)&&i.push({label:"simulated, peak of the run",role:"peak",..._l(t,o)}),i.push(...nC(n)),i.length===0)return null;let a=mr(n,"pull")?.where;return{id:"tension",title:"Tension along the route",caption:"Tension of the cable that passes a place. The theory for the other direction is of the whole route full of cable."+(a?` The largest was at ${a}.`:""),...ia,yLabel:"tension",yUnit:"N",curves:i,levels:Yr(n,"pull"),...s?{band:s}:{}}}var iC=n=>n.map(e=>e===null?null:Math.max(0,-e));function xx(n){let e=mr(n,"buckling"),t=e?.value?xl(n):null;if(!t)return null;let s=t.curves.filter(r=>["envelope","simulated","theory"].includes(r.role)).filter(r=>r.label!=="simulated, largest").map(r=>({...r,y:iC(r.y),label:r.label.replace("least","largest of the run"),quiet:!1}));return s.some(r=>r.y.some(o=>(o??0)>0))?{id:"push",title:"Push along the route",caption:"What a machine pushes the cable with, where its tension is below 0. Beyond the allowed push it snakes or coils in a duct, or bows between carriers and guides."+(e?.where?` It is nearest to that at ${e.where}.`:""),...ia,yLabel:"push",yUnit:"N",curves:s,levels:Yr(n,"buckling","push")}:null}function sC(n){let e=n.theory_along;return!e||!sn(e.forward_sidewall_N_per_m)?null:{label:"reference theory, T/R",role:"theory",x:e.s_m,y:e.forward_sidewall_N_per_m}}function rC(n){let{theory_along:e,geometry:t}=n,i=e&&sn(e.curvature_per_m)?e:t?.route;if(!i?.curvature_per_m||!sn(i.curvature_per_m))return null;let s=i.curvature_per_m.map(r=>r===null?null:Math.abs(r));return{label:"route",role:"theory",x:i.s_m,y:s}}function yx(n){let e=n.envelope?.place,t=[];e&&sn(e.sidewall_max_N_per_m)&&t.push({label:"simulated, largest of the run",role:"simulated",x:e.s_m,y:e.sidewall_max_N_per_m});let i=sC(n);return i&&t.push(i),t.length===0?null:{id:"sidewall",title:"Sidewall pressure along the route",caption:"Force per length with which the cable presses sideways.",...ia,yLabel:"sidewall pressure",yUnit:"N/m",curves:t,levels:Yr(n,"sidewall")}}function vx(n){let e=n.envelope?.place;if(!e||!sn(e.curvature_max_per_m))return null;let t=[{label:"cable, largest of the run",role:"simulated",x:e.s_m,y:e.curvature_max_per_m}],i=rC(n);i&&t.push(i);let s=mr(n,"bend_radius")?.limit;return{id:"curvature",title:"Curvature along the route",caption:"One over the radius to which the cable is bent. The allowed curvature is one over the allowed radius.",...ia,yLabel:"curvature",yUnit:"1/m",curves:t,levels:s?[{label:"allowed",value:1/s}]:[]}}function bx(n){let e=n.geometry;if(!e||e.route.s_m.length<2)return null;let{s_m:t,position_m:i}=e.route,s=i.map(l=>l[2]),r=[{label:"route",role:"route",x:t,y:s}],o=e.rollers.filter(l=>l.s_m!==null);o.length>0&&r.push({label:"rollers",role:"ground",points:!0,x:o.map(l=>l.s_m),y:o.map(l=>l.position_m[2])});let a=e.conveyors;if(a.length>0){let l=[],c=[];for(let{from_m:u,to_m:d}of a)l.push(u,d,d+1e-6),c.push(ys(t,s,u),ys(t,s,d),null);r.push({label:"conveyors",role:"second",x:l,y:c})}return{id:"profile",title:"Profile",caption:"Height over the place along the route; the scales of the two axes differ.",...ia,yLabel:"height",yUnit:"m",fromZero:!1,span:2,curves:r,height:200}}function Mx(n){let e=yt(n.rollers,"s_m");if(!sn(e))return null;let t=[],i=(o,a,l)=>{let c=yt(n.rollers,o);sn(c)&&t.push({label:a,role:l,points:!0,..._l(e,c)})};if(i("steady_N","steady mean","simulated"),i("peak_N","peak of the run","second"),t.length===0)return null;let s=new Set((yt(n.rollers,"rating_N")??[]).filter(o=>o!==null)),r=s.size===1?[...s][0]:null;return{id:"rollers",title:"Loads of the rollers along the route",caption:e.includes(null)?"Rollers that were placed by coordinates have no place along the route; the table below has all.":"Where each roller stands.",...ia,yLabel:"load",yUnit:"N",curves:t,levels:r?[{label:"rating",value:r}]:[]}}function yl(n){let e=new Map;return n.map(t=>{let i=t.label||t.summary.title||"run",s=(e.get(i)??0)+1;return e.set(i,s),s===1?i:`${i} (${s})`})}function Th(n,e){let t=yl(n);return n.flatMap((i,s)=>{let r=e(i);return r&&sn(r.y)?[{label:t[s]??"",role:zs[s],...r}]:[]})}var oC=n=>{let e=xl(n)?.curves.find(({role:t})=>t==="simulated");return e?{x:e.x,y:e.y}:null},aC=n=>{let e=n.envelope?.place;return e?.sidewall_max_N_per_m?{x:e.s_m,y:e.sidewall_max_N_per_m}:null},lC=n=>{let[e,t]=[yt(n.series,"time_s"),yt(n.series,"winch_force_N")];return e&&t?{x:e,y:t}:null},cC=n=>{let[e,t]=[yt(n.series,"head_at_m"),yt(n.series,"winch_force_N")],i=e?hn(e):null;return e&&t&&i&&i[1]-i[0]>.5?{x:e,y:t}:null};function Sx(n){return[{id:"together-tension",title:"Tension along the route, all runs",caption:"Steady means of the simulation; of a run without them the mean of the run.",along:"place",xLabel:"place along the route",yLabel:"tension",yUnit:"N",curves:Th(n,oC)},{id:"together-sidewall",title:"Sidewall pressure along the route, all runs",caption:"The largest of each run.",along:"place",xLabel:"place along the route",yLabel:"sidewall pressure",yUnit:"N/m",curves:Th(n,aC)},{id:"together-force",title:"Force at the winch over time, all runs",caption:"As simulated.",along:"time",xLabel:"time",yLabel:"force",yUnit:"N",curves:Th(n,lC)},{id:"together-head",title:"Force at the winch over the place of the cable\u2019s head, all runs",caption:"As simulated, of the runs in which the head moves along the route.",along:"place",xLabel:"place of the cable\u2019s head along the route",yLabel:"force",yUnit:"N",curves:Th(n,cC)}].filter(t=>t.curves.length>1)}function Rt(n,e,...t){let i=P("h2",{id:`${n}-heading`},e);return P("section",{id:n,"aria-labelledby":`${n}-heading`},i,...t)}function pn(n){return P("p",{class:"note"},n)}var uC={safe:"M6 12.5l4 4 8-9",conditional:"M9 9.2c0-4.2 6.4-3.6 6 .2-.3 2.4-3 2.3-3 5M12 17.2v.6",unsafe:"M7 7l10 10M17 7L7 17",untrusted:"M12 6v8M12 17.2v.6",unjudged:"M7 12h10"};function gr(n){let e=je("circle",{cx:12,cy:12,r:11,fill:"currentColor"}),t=je("path",{d:uC[n],fill:"none",stroke:"var(--surface)","stroke-width":2.6,"stroke-linecap":"round"});return je("svg",{viewBox:"0 0 24 24",class:"sign","aria-hidden":"true"},e,t)}function Eh(n,e){let i=Math.max(0,Math.min(1.5,n))*66,s=je("rect",{x:0,y:3,width:i,height:8,class:"bar",rx:1}),r=je("path",{d:"M66 0V14",class:"bar-limit"}),o=je("svg",{viewBox:"0 0 100 14",class:"usage","aria-hidden":"true",preserveAspectRatio:"none"},s,r);return P("span",{class:`usage-box ${e}`},o)}function _r(n,e,t,i,s){let r=i.filter(({key:l})=>t.some(c=>c[l]!==void 0&&c[l]!==null&&c[l]!=="")),o=r.map(({key:l,unit:c})=>{let u=t.map(d=>typeof d[l]=="number"?Math.abs(d[l]):0);return c?kt(c,s,Math.max(0,...u)):null}),a={name:`hawser-${n}`,columns:r.map(({label:l},c)=>({label:l,unit:o[c]?.symbol??""})),rows:t.map(l=>r.map(({key:c},u)=>{let d=l[c];return typeof d=="number"?d*(o[u]?.factor??1):d}))};return P("div",{class:"record"},Ed(a,e),Xi(()=>a))}function Dn(n,e,t=""){return P("div",{class:"fact"},P("dt",{},n),P("dd",{},e),t?P("dd",{class:"detail"},t):null)}function cp(n,e,t,i){if(n==null||e===null||e===void 0||n===0)return"";let s=Qe(100*e/Math.abs(n),"%",i,2);return`\xB1 ${Qe(e,t,i,2)} (${s})`}var hC=(n,e)=>hn(yt(n.rollers,e)??[])?.[1]??null;function dC(n){let e=(t,i,s)=>({label:t,unit:i,values:n.map(r=>s(r)??null)});return[e("Pull, steady mean","N",t=>t.summary.pull_force?.steady_mean_N),e("Pull, peak","N",t=>t.summary.pull_force?.peak_N),e("Pull by the reference theory","N",t=>t.summary.theory?.reference_total_N),e("Largest roller load","N",t=>hC(t,"peak_N")),e("Speed, steady mean","m/s",t=>t.summary.speed?.steady_m_per_s),e("Settled after","s",t=>t.summary.speed?.settle_time_s)]}function Tx(n){let e=new Map;for(let t of n)for(let i of t.summary.limits??[])e.has(i.name)||e.set(i.name,{label:Bn(i.name),unit:$r(i),values:[]});for(let[t,i]of e)i.values=n.map(s=>s.summary.limits?.find(r=>r.name===t)?.value??null);return[...e.values()]}function fC(n){return Tx(n).map(e=>{let t=i=>i.summary.limits?.find(s=>Bn(s.name)===e.label)?.margin??null;return{label:e.label,unit:"%",values:n.map(i=>{let s=t(i);return s===null?null:100*s})}})}function pC(n){let e=n.map(i=>{let s=yt(i.stations,"mean_N")??[];return new Map(pr(i.stations,"name").map((r,o)=>[r,s[o]??null]))});return[...new Set(e.flatMap(i=>[...i.keys()]))].map(i=>({label:i,unit:"N",values:e.map(s=>s.get(i)??null)}))}function mC(n){let e=[{label:"Key figures",rows:dC(n)},{label:"Limits: what was found",rows:Tx(n)},{label:"Limits: margin",rows:fC(n)},{label:"Stations: mean tension",rows:pC(n)}],t=i=>i.values.some(s=>s!==null);return e.map(({label:i,rows:s})=>({label:i,rows:s.filter(t)})).filter(({rows:i})=>i.length>0)}function gC(n,e){let t=n.values[0]??null;if(t===null||e===null)return"";let i=n.unit==="%"?e-t:100*(e-t)/Math.abs(t);if(!Number.isFinite(i))return"";let s=dn(i,2);return`${i>0?"+":""}${s}\u202F${n.unit==="%"?"points":"%"}`}function _C(n,e){let t=Math.max(...n.values.map(r=>Math.abs(r??0))),i=n.unit==="%"?{symbol:"%",factor:1}:kt(n.unit,e.units,t),s=n.values.map((r,o)=>{let a=r===null?ai:dn(r*i.factor),l=o===0?"":gC(n,r);return P("td",{class:r===null?"unknown":"number"},a,l?P("span",{class:"difference"},l):null)});return P("tr",{},P("th",{scope:"row"},ft(n.label),i.symbol?`, ${i.symbol}`:""),...s)}function xC(n,e){return{name:"hawser-comparison",columns:["group","figure","unit",...e].map(t=>({label:t})),rows:n.flatMap(t=>t.rows.map(i=>[t.label,i.label,i.unit,...i.values]))}}var wx=24;function Ex(n){let{runs:e}=n.data;if(e.length<2)return null;let t=yl(e),i=mC(e),s=e.map(h=>{let f=ml(h),p={safe:"safe",conditional:"safe only if",unsafe:"not safe",untrusted:"not trusted",unjudged:"not judged"};return P("td",{},P("span",{class:`standing-word ${f}`},gr(f),p[f]))}),r=t.map((h,f)=>{let p=n.store.get("run")===f,v=P("button",{type:"button",class:"pick","aria-pressed":String(p),onclick:()=>n.store.set("run",f)},ft(h));return P("th",{scope:"col"},v)}),o=i.map(h=>{let f=P("tr",{class:"group"},P("th",{colspan:t.length+1,scope:"rowgroup"},h.label));return P("tbody",{},f,...h.rows.slice(0,wx).map(p=>_C(p,n)))}),l=`Differences are from the first run. Choose a run to see all of it below, and in three dimensions.${i.some(h=>h.rows.length>wx)?" Long lists are cut; the CSV has all of them.":""}`,c=P("table",{class:"compare"},P("caption",{},l),P("thead",{},P("tr",{},P("td"),...r)),P("tbody",{},P("tr",{},P("th",{scope:"row"},"Verdict"),...s)),...o),u=P("div",{class:"scroll",tabindex:0,role:"region","aria-label":"Comparison of the runs"},c),d=Sx(e).map(h=>n.figure(h));return Rt("compare","Comparison",u,Xi(()=>xC(i,t)),...d)}function sa(n,e,t,i,s,r,o){let a=yt(n.series,"time_s");if(!sn(a))return null;let l=o.flatMap(({name:h,label:f,role:p})=>{let v=yt(n.series,h);return sn(v)?[{label:f,role:p,x:a,y:v}]:[]});if(l.length===0)return null;let c=$_(n),u=q_(n),d=u.length>0?" Numbers: see Events.":"";return{id:e,title:t,caption:i+d,along:"time",xLabel:"time",yLabel:s,yUnit:r,curves:l,events:u,...c?{window:c}:{}}}function Ax(n){let e=sa(n,"force","Force at the winch over time","Forces of the run, and what the theory expects.","force","N",[{name:"winch_force_N",label:"winch",role:"simulated"},{name:"max_tension_N",label:"largest tension anywhere",role:"second"},{name:"tail_tension_N",label:"tail",role:"third"},{name:"reference_N",label:"winch by the reference theory",role:"theory"}]);return e&&{...e,levels:Yr(n,"pull")}}function up(n){let e=yt(n.series,"head_at_m"),t=yt(n.series,"time_s"),i=sn(e)?hn(e):null;if(!i||i[1]-i[0]<.5||!e||!t)return null;let s=e.map((u,d)=>d).filter(u=>e[u]!==null);s.sort((u,d)=>e[u]-e[d]);let r=u=>s.map(d=>u[d]??null),o=r(e),a=[],l=(u,d,h)=>{let f=yt(n.series,u);sn(f)&&a.push({label:d,role:h,x:o,y:r(f)})};l("winch_force_N","simulated","simulated"),l("reference_N","reference theory","theory");let c=n.summary.pull_by_position??[];if(c.length>0){let u=d=>c.map(h=>h[d]??null);a.push({label:"simulated, means of stretches",role:"second",points:!0,x:u("head_m"),y:u("pull_N")})}return a.length===0?null:{id:"head",title:"Force at the winch over the place of the cable\u2019s head",caption:"How the pull grows while the cable comes in: what the crew sees at the winch when the head is at a place.",along:"head",xLabel:"place of the cable\u2019s head along the route",yLabel:"force",yUnit:"N",curves:a,levels:Yr(n,"pull"),clock:{time:t,head:e}}}function Cx(n){let e=Object.keys(n.series??{}).filter(s=>/^speed_\d+_m_per_s$/.test(s)),t=e.slice(0,zs.length),i=e.length>t.length?` The first ${t.length} of ${e.length} watched segments.`:"";return sa(n,"speed","Speeds over time",`Segments are numbered from the tail, 0.${i}`,"speed","m/s",[{name:"winch_speed_m_per_s",label:"winch",role:"theory"},...t.map((s,r)=>({name:s,label:`segment ${s.split("_")[1]}`,role:zs[r]}))])}var Px={"vector-effect":"non-scaling-stroke"};function Ix(n){let e=t=>{let i=n.route.position_m.map(s=>s[t]);return Math.max(...i)-Math.min(...i)};return e(1)>1.2*e(0)?t=>[t[1],t[0]]:t=>[t[0],-t[1]]}function Rx(n,e,t){let i=n.map(s=>e(s).map(r=>r.toFixed(3)).join(" ")).join("L");return je("path",{d:`M${i}`,fill:"none",class:t,...Px})}function Ah([n,e]){return`M${n} ${e}h0.001`}function hp(n,e,t){return je("path",{d:Ah(n),class:e,...Px},je("title",{},t))}function Lx(n,e){let t=(s,r)=>s.filter(({points_m:o})=>o.length>1).map(({points_m:o})=>Rx(o,e,r)),i=[...t(n.surfaces,"plan-surface"),Rx(n.route.position_m,e,"plan-route"),...t(n.conveyors,"plan-conveyor"),...n.rollers.map(s=>hp(e(s.position_m),"plan-roller",s.name))];return n.reel&&i.push(hp(e(n.reel.center_m),"plan-reel","reel")),n.winch&&i.push(hp(e(n.winch.position_m),"plan-winch","winch")),i}function Nx(n){let t=[{name:"route",label:"route",there:!0,long:!0},{name:"roller",label:"rollers",there:n.rollers.length>0,long:!1},{name:"conveyor",label:"conveyors",there:n.conveyors.length>0,long:!0},{name:"surface",label:"ducts, trays, walls",there:n.surfaces.length>0,long:!0},{name:"reel",label:"reel",there:n.reel!==null,long:!1},{name:"winch",label:"winch",there:n.winch!==null,long:!1}].filter(({there:i})=>i).map(({name:i,label:s,long:r})=>{let o=je("path",{d:r?"M2 6H24":Ah([13,6]),class:`plan-${i}`}),a=je("svg",{width:26,height:12,class:"swatch","aria-hidden":"true"},o);return P("li",{},P("span",{class:"legend-item"},a,s))});return P("ul",{class:"legend"},...t)}function Dx(n,e,t,i){let s=null,r=1/0;return n.route.position_m.forEach((o,a)=>{let[l,c]=e(o),u=(l-t)**2+(c-i)**2;u<r&&([r,s]=[u,n.route.s_m[a]??null])}),s}function Fx(n,e){let{symbol:t,factor:i}=kt("m",e,1),s=(h,f,p,v)=>[h,f,p===null?null:p*i,...[0,1,2].map(g=>v?.[g]===void 0?null:v[g]*i)],{route:r,rollers:o,conveyors:a,surfaces:l,reel:c,winch:u}=n,d=(h,f,p,v,g)=>[s(`${h}, beginning`,f,v,p[0]),s(`${h}, end`,f,g,p.at(-1))];return{name:"hawser-plan",columns:[{label:"what"},{label:"name"},{label:"place along the route",unit:t},...["x","y","z"].map(h=>({label:h,unit:t}))],rows:[...c?[s("reel","",null,c.center_m)]:[],...u?[s("winch","",null,u.position_m)]:[],...a.flatMap(h=>d("conveyor",h.name,h.points_m,h.from_m,h.to_m)),...l.flatMap(h=>d(h.kind,h.name,h.points_m,h.from_m??null,h.to_m??null)),...o.map(h=>s(h.kind,h.name,h.s_m,h.position_m)),...r.s_m.map((h,f)=>s("route","",h,r.position_m[f]))]}}function Rh(n){let e=n.map(r=>r[0]),t=n.map(r=>r[1]),[i,s]=[Math.min(...e),Math.min(...t)];return{x:i,y:s,width:Math.max(...e)-i,height:Math.max(...t)-s}}function dp(n,e){let t=Math.max(n.width,n.height*e),i=t/e;return{x:n.x+(n.width-t)/2,y:n.y+(n.height-i)/2,width:t,height:i}}function vl(n,e){let[t,i]=[n.width*e,n.height*e];return{x:n.x+(n.width-t)/2,y:n.y+(n.height-i)/2,width:t,height:i}}var Ch=(n,e,t)=>({...n,x:n.x+e*n.width,y:n.y+t*n.height});function yC(n,e,t){switch(n){case"+":case"=":return vl(e,.5);case"-":return e.width*2>t.width?t:vl(e,2);case"0":return t;case"ArrowLeft":return Ch(e,-.1,0);case"ArrowRight":return Ch(e,.1,0);case"ArrowUp":return Ch(e,0,-.1);case"ArrowDown":return Ch(e,0,.1);default:return null}}var Ph=class{constructor(e,t,i,s,r){this.drawing=e;this.all=i;this.onView=s;this.onPoint=r;this.view=i,e.append(this.band),e.addEventListener("mousedown",o=>{this.start=this.at(o),o.preventDefault()}),e.addEventListener("mousemove",o=>this.move(this.at(o))),e.addEventListener("mouseup",o=>this.end(this.at(o))),e.addEventListener("mouseleave",()=>{this.end(null),r(null)}),e.addEventListener("dblclick",()=>this.show(i)),t.addEventListener("keydown",o=>{let a=o.ctrlKey||o.metaKey||o.altKey?null:yC(o.key,this.view,i);a&&(o.preventDefault(),this.show(a))}),this.show(i)}drawing;all;onView;onPoint;view;start=null;band=je("rect",{class:"plan-band","vector-effect":"non-scaling-stroke",width:0,height:0});show(e){this.view=e,this.drawing.setAttribute("viewBox",`${e.x} ${e.y} ${e.width} ${e.height}`),this.onView(e)}zoomIn(){this.show(vl(this.view,.5))}showAll(){this.show(this.all)}at(e){let t=this.drawing.getScreenCTM();if(!t)return[0,0];let{x:i,y:s}=new DOMPoint(e.clientX,e.clientY).matrixTransform(t.inverse());return[i,s]}move(e){if(this.start)for(let[t,i]of Object.entries(Rh([this.start,e])))this.band.setAttribute(t,String(i));this.onPoint(e)}end(e){let t=this.start&&e?Rh([this.start,e]):null;this.start=null,this.band.setAttribute("width","0"),t&&Math.max(t.width,t.height)>this.view.width*.02&&this.show(dp(t,this.all.width/this.all.height))}};var Ux=900,vC="Arrow keys move it, plus and minus zoom, 0 shows all.";function Ox(n){let{run:e,store:t,units:i}=n,s=e.geometry;if(!s||s.route.position_m.length<2)return null;let r=Ix(s),o=[s.reel?.center_m,s.winch?.position_m].filter(y=>y!==void 0),a=s.rollers.map(y=>y.position_m),l=Rh([...s.route.position_m,...a,...o].map(r)),c=Math.min(6,Math.max(1.8,l.width/Math.max(l.height,1e-9))),u=vl(dp({...l,width:Math.max(l.width,.001)},c),1.1),d=je("path",{class:"plan-pointer","vector-effect":"non-scaling-stroke",d:""}),h=`Plan of the route, ${Qe(s.route.s_m.at(-1),"m",i)} long`,f=je("svg",{class:"plan",width:Ux,height:Ux/c,role:"img","aria-label":h},...Lx(s,r),d),p=P("div",{class:"frame",tabindex:0,role:"group","aria-label":`${h}. ${vC}`},f),v=P("p",{class:"plan-scale"}),g=kt("m",i,1),m={},S=new Ph(f,p,u,y=>v.textContent=`Width of the drawing: ${dn(y.width*g.factor,3)} ${g.symbol}.`,y=>{let E=y&&Dx(s,r,y[0],y[1]);t.set("place",E,m),A(E)}),A=y=>{let{s_m:E,position_m:F}=s.route,[I,U,k]=[0,1,2].map(O=>y===null?null:ys(E,F.map($=>$[O]),y)),X=typeof I=="number"&&typeof U=="number"&&typeof k=="number";d.setAttribute("d",X?Ah(r([I,U,k])):"")};n.onDispose(t.subscribe("place",(y,E)=>E!==m&&A(y))),A(t.get("place"));let b=P("div",{class:"tools"},ei("Zoom in",()=>S.zoomIn()),ei("Show all",()=>S.showAll())),[C,T]=Yl(()=>Fx(s,i),"What stands where",!1,()=>{});C&&b.append(...C.childNodes);let N=T?[T]:[];return P("figure",{id:"figure-plan",class:"figure"},P("h3",{},"Plan"),Nx(s),p,P("figcaption",{},P("p",{class:"caption"},"The route from above, both directions to the same scale."),v,b,...N))}var Ih="These results are of an older hawser, or of a run that was cut short: compute them again to have it.",kx=n=>{let{run:e}=n,t=[],i=xl(e);t.push(i?n.figure(i):pn(`There is no tension along the route in these results. ${Ih}`));let s=xx(e);s&&t.push(n.figure(s));let r=yx(e);t.push(r?n.figure(r):pn(`There is no sidewall pressure along the route in these results. ${Ih}`));let o=vx(e);return o&&t.push(n.figure(o)),Rt("along","Along the route",...t)},Bx=n=>{let e=bx(n.run),t=Ox(n);return!e||!t?Rt("route","Plan and profile",pn(`There is no geometry of the route in these results. ${Ih}`)):Rt("route","Plan and profile",t,n.figure(e))},Vx=n=>{let{run:e}=n,t=[Ax(e),up(e),Cx(e)].filter(s=>s!==null);if(t.length===0)return Rt("time","Over time",pn(`There is nothing over time in these results. ${Ih}`));let i=up(e)?null:pn("The cable\u2019s head does not move along the route in this run, so there is no force over its place.");return Rt("time","Over time",...t.map(s=>n.figure(s)),i)};function bC(n,e){if(n==null||!e)return"";let t=100*(n-e)/e;return`simulated ${dn(Math.abs(t),2)}\u202F% ${t<0?"below":"above"}`}function MC(n){let{run:e,units:t}=n,i=yt(e.rollers,"peak_N"),s=i?hn(i)?.[1]:void 0;if(!i||s===void 0)return null;let r=i.indexOf(s),o=yt(e.rollers,"rating_N")?.[r]??null,a=pr(e.rollers,"name")[r]??"",l=o===null?"no rating given":`rated ${Qe(o,"N",t)}`;return Dn("Largest roller load",Qe(s,"N",t),P("span",{},ft(a),`, ${l}`))}function zx(n,e){let t=mr(n.run,e);if(!t||t.value===null)return null;let i=e==="sidewall"?"N/m":"m",s=t.where?ft(kn(t.where,n.units)):"";return Dn(Bn(e),Qe(t.value,i,n.units),s)}function SC(n){let e=n.run.summary.passes;if(!e)return null;let t=(e.pass?.length??0)>2,i={replaced:`All figures of this page are those of a ${t?"third":"second"} pass with finer settings; those of the first stand under`,compared:`All figures of this page are those of the first of ${t?"three":"two"} passes, and their \xB1 is from all; the others\u2019 stand under`,declined:"A second pass with finer settings would narrow \xB1; what it would take stands under"},s=P("a",{href:"#trust"},"trust");return P("p",{class:"note"},i[e.outcome]??"A second pass was begun and did not end; why stands under"," ",s,".")}function Gx(n){let{run:e,units:t}=n,{pull_force:i,theory:s,speed:r}=e.summary,o=s?.reference_total_N,a=hn(yt(e.series,"max_tension_N")??[])?.[1]??mr(e,"pull")?.value,l=r?.settle_time_s,c=[Dn("Pull, steady mean",Qe(i?.steady_mean_N,"N",t),cp(i?.steady_mean_N,i?.steady_mean_error?.total_N,"N",t)),Dn("Pull, peak of the run",Qe(i?.peak_N,"N",t),cp(i?.peak_N,i?.peak_error?.total_N,"N",t)),Dn("Pull by the reference theory",Qe(o,"N",t),bC(i?.steady_mean_N,o)),Dn("Largest tension anywhere",Qe(a,"N",t),"rope included"),zx(n,"sidewall"),zx(n,"bend_radius"),MC(n),Dn("Speed, steady mean",Qe(r?.steady_m_per_s,"m/s",t),l==null?"":`settled after ${Qe(l,"s",t)}`)],d=i?.steady_mean_error||i?.peak_error?pn("\xB1 is what a figure may be off by through the numbers alone: steps in time, length of segments, friction at rest."):null;return Rt("key-figures","Key figures",P("dl",{class:"facts"},...c),d,SC(n))}function Hx(n){return n.ok===null?"unjudged":n.ok?"safe":"unsafe"}var Wx={safe:"holds",conditional:"",unsafe:"broken",unjudged:"not judged",untrusted:""};function wC(n,e){let{units:t,store:i}=e,s=$r(n),r=Hx(n),o=n.margin===null?ai:`${dn(100*n.margin,3)}\u202F%`,a=/^(-?\d+(?:\.\d+)?) m\b/.exec(n.where),l=a?Number(a[1]):null,c=d=>()=>{l!==null&&i.set("place",d?l:null)},u=d=>P("td",{class:d===ai?"unknown":"number"},d);return P("tr",{class:r,onmouseenter:c(!0),onmouseleave:c(!1)},P("th",{scope:"row"},Bn(n.name)),P("td",{class:"standing"},P("span",{class:`standing-word ${r}`},gr(r),Wx[r])),u(Qe(n.value,s,t)),u(Qe(n.limit,s,t)),u(o),P("td",{class:"usage-cell"},n.margin===null?null:Eh(1-n.margin,r)),P("td",{},ft(kn(n.where,t))),P("td",{class:"source"},ft(kn(n.source,t))))}var TC=["Limit","","Found","Allowed","Margin","Used","Where","Source, or why it was not judged"];function Xx(n){let{run:e,units:t}=n,i=e.summary.limits;if(!i)return Rt("limits","Limits",pn("These results hold no limits: they are of an older hawser."));if(i.length===0)return Rt("limits","Limits",pn("The case has no section \u201Climits\u201D, so nothing was judged."));let s=[...pl(e),...i.filter(c=>c.ok===null||c.margin===null)],r=TC.map(c=>P("th",{scope:"col","aria-label":c||"Standing"},c)),o=P("table",{class:"limits"},P("caption",{},"The smallest margin first. The line in a bar is all that is allowed."),P("thead",{},P("tr",{},...r)),P("tbody",{},...s.map(c=>wC(c,n)))),a=()=>({name:"hawser-limits",columns:["limit","standing","found","allowed","unit","margin","where","source"].map(c=>({label:c})),rows:s.map(c=>{let{symbol:u,factor:d}=kt($r(c),t,c.limit??c.value??0),h=f=>f===null?null:f*d;return[c.name,Wx[Hx(c)],h(c.value),h(c.limit),u,c.margin,c.where,c.source]})}),l=P("div",{class:"scroll",tabindex:0,role:"region","aria-label":"Table of limits"},o);return Rt("limits","Limits",l,Xi(a))}function EC(n,e,t){let i=[...n].sort((o,a)=>Math.abs(Number(a[t]??0))-Math.abs(Number(o[t]??0))),s=new Set(i.slice(0,zs.length)),r=n.filter(o=>s.has(o)).map((o,a)=>({name:`${String(o.name)}_${e}`,label:String(o.name),role:zs[a]}));return{columns:r,left:n.length-r.length}}function Lh(n,e,t){let{columns:i,left:s}=EC(e,t.suffix,t.size),r=s>0?` The ${i.length} largest; ${s} more are in the table of machines.`:"";return sa(n,t.id,t.title,t.caption+r,t.label,t.unit,i)}var fp=n=>n.filter(e=>e!==null);function qx(n){let e=n.summary.conveyors??[];return fp([Lh(n,e,{id:"conveyor-force",title:"Forces of the conveyors",caption:"Force on the cable along the pull.",suffix:"force_N",size:"peak_N",label:"force",unit:"N"}),Lh(n,e,{id:"conveyor-slip",title:"Slip of the conveyors",caption:"Speed of the cable less that of the belt; 0 where there is no cable.",suffix:"slip_m_per_s",size:"peak_N",label:"slip",unit:"m/s"})])}function $x(n){let e=n.summary.motors??[];return fp([Lh(n,e,{id:"motor-torque",title:"Torques of the driven rollers",caption:"Torque on the roller, positive with the pull.",suffix:"torque_N_m",size:"peak_N_m",label:"torque",unit:"N m"}),Lh(n,e,{id:"motor-speed",title:"Speeds of the driven rollers",caption:"Speed of the roller\u2019s surface.",suffix:"speed_m_per_s",size:"peak_N_m",label:"speed",unit:"m/s"})])}function Yx(n){return fp([sa(n,"reel-speed","Speed of the reel","Angular speed of the drum.","speed","rad/s",[{name:"reel_speed_rad_per_s",label:"reel",role:"simulated"}]),sa(n,"reel-cable","Cable on the reel","What has left the drum, and what is still on it.","length","m",[{name:"paid_out_m",label:"paid out",role:"simulated"},{name:"wound_m",label:"wound",role:"second"}])])}var AC=[{key:"name",label:"conveyor"},{key:"from_m",label:"from",unit:"m"},{key:"to_m",label:"to",unit:"m"},{key:"grip_N",label:"largest force",unit:"N"},{key:"reference_N",label:"theory reckons with",unit:"N"},{key:"steady_mean_N",label:"steady mean",unit:"N"},{key:"peak_N",label:"peak",unit:"N"},{key:"belt_m_per_s",label:"belt",unit:"m/s"},{key:"slip_m_per_s",label:"slip",unit:"m/s"},{key:"slipping",label:"share of time slipping",unit:"1"}],CC=[{key:"name",label:"driven roller"},{key:"at_m",label:"place",unit:"m"},{key:"limit_N_m",label:"set or largest torque",unit:"N m"},{key:"reference_N",label:"theory reckons with",unit:"N"},{key:"steady_mean_N_m",label:"steady mean",unit:"N m"},{key:"peak_N_m",label:"peak",unit:"N m"},{key:"surface_m_per_s",label:"surface",unit:"m/s"},{key:"power_W",label:"power",unit:"W"},{key:"at_limit",label:"share of time at its limit",unit:"1"}],RC=[{key:"name",label:"surface"},{key:"kind",label:"kind"},{key:"from_m",label:"from",unit:"m"},{key:"to_m",label:"to",unit:"m"},{key:"clearance_m",label:"clearance",unit:"mm"},{key:"jam_ratio",label:"jam ratio",unit:"1"},{key:"steady_normal_N",label:"normal force, steady mean",unit:"N"},{key:"steady_friction_N",label:"friction, steady mean",unit:"N"},{key:"peak_line_load_N_per_m",label:"largest force per length",unit:"N/m"},{key:"peak_line_load_error",label:"off by at most",unit:"N/m"},{key:"peak_at_m",label:"at",unit:"m"}];function pp(n,e){return e.map(t=>n.figure(t))}var Zx=n=>{let e=n.run.summary.conveyors??[];if(e.length===0)return null;let t=_r("conveyors","Conveyors",e,AC,n.units);return Rt("conveyors","Conveyors",t,...pp(n,qx(n.run)))},Kx=n=>{let e=n.run.summary.motors??[];if(e.length===0)return null;let t=_r("motors","Driven rollers",e,CC,n.units);return Rt("motors","Driven rollers",t,...pp(n,$x(n.run)))},Jx=n=>{let e=Yx(n.run);return e.length>0?Rt("reel","Reel",...pp(n,e)):null},jx=n=>{let e=n.run.summary.surfaces??[];return e.length===0?null:Rt("surfaces","Ducts, trays and walls",_r("surfaces","Surfaces",e,RC,n.units))};function ey(n,e){return P("div",{class:"scroll",tabindex:0,role:"region","aria-label":n},e)}function ty(...n){return P("thead",{},P("tr",{},...n.map(e=>P("th",{scope:"col"},e))))}var PC=[{key:"which",label:"pass"},{key:"segments",label:"segments",unit:"1"},{key:"accuracy",label:"accuracy",unit:"1"},{key:"v_s_factor",label:"speed at which friction comes in, of the case\u2019s",unit:"1"},{key:"steady_mean_N",label:"pull, steady mean",unit:"N"},{key:"steady_mean_bar_N",label:"\xB1 by itself",unit:"N"},{key:"peak_N",label:"pull, peak",unit:"N"},{key:"peak_bar_N",label:"\xB1 by itself",unit:"N"},{key:"steps",label:"steps",unit:"1"},{key:"wall_time_s",label:"computed in",unit:"s"}];function IC(n,e){let t=n.pass??[],i=n.outcome==="replaced"?t.length-1:0,s=t.map((o,a)=>({which:`${["first","second","third"][a]??a+1}${a===i?", shown":""}`,...o})),r=`${n.why}: ${n.says}.`;return[P("h3",{},"Passes"),P("p",{},ft(kn(r.charAt(0).toUpperCase()+r.slice(1),e))),_r("passes","What each pass found before it knew of the others.",s,PC,e)]}var ny=({run:n,units:e})=>{let t=n.summary.trust;if(!t)return Rt("trust","Can these figures be trusted?",pn("These results hold no conditions of trust: they are of an older hawser."));let i=t.filter(c=>c.holds===!1).length,s=i===0?`Yes: all ${t.length} conditions hold.`:`No: ${i} of ${t.length} conditions ${i===1?"does":"do"} not hold.`,r=(c,u)=>c===null?ai:Rl(u)?Qe(c,u,e,3):`${dn(c,3)} ${u}`,o=c=>{let u=c.holds===!1?"unsafe":c.holds?"safe":"unjudged",d=c.holds===!1?"fails":c.holds?"holds":"not judged";return P("tr",{class:u},P("th",{scope:"row"},Bn(c.name)),P("td",{class:"standing"},P("span",{class:`standing-word ${u}`},gr(u),d)),P("td",{class:"number"},r(c.value,c.unit)),P("td",{class:"number"},r(c.allowed,c.unit)),P("td",{class:"source"},c.holds===!1?ft(kn(c.remedy,e)):null))},a=[...t].sort((c,u)=>+(c.holds!==!1)-+(u.holds!==!1)),l=P("table",{},P("caption",{},"Conditions under which the run is worth judging."),ty("Condition","Standing","Found","Allowed","What to do"),P("tbody",{},...a.map(o)));return Rt("trust","Can these figures be trusted?",P("p",{},s),ey("Conditions of trust",l),...n.summary.passes?IC(n.summary.passes,e):[])},Qx={given:"given in the case",catalogue:"from the catalogue",estimated:"estimated",default:"default"};function LC(n,e){let t=new Map((e??[]).map(({key:i,source:s})=>[i,s??""]));return n?n.map(({key:i,value:s,origin:r,where:o})=>[i,s,r,o||t.get(i)||""]):(e??[]).map(({key:i,value:s,origin:r,source:o})=>[i,s,r,o??""])}var iy=({run:n})=>{let e=LC(n.inputs,n.summary.assumptions),t="Inputs and assumptions";if(e.length===0)return Rt("inputs",t,pn("These results hold no list of inputs. The case file has them."));let i=new Map;for(let u of e)i.set(u[2]??"",(i.get(u[2]??"")??0)+1);let s=[...i].map(([u,d])=>`${d} ${Qx[u]??u}`).join(", "),r=([u="",d="",h="",f=""])=>P("tr",{class:`origin-${/^\w+$/.test(h)?h:"other"}`},P("th",{scope:"row",class:"key"},ft(u)),P("td",{},ft(d)),P("td",{},P("span",{class:"origin"},Qx[h]??ft(h))),P("td",{class:"source"},ft(f))),o=P("table",{class:"inputs"},P("caption",{},"As they were read, with their units as in the case."),ty("Input","Value","Origin","Where from"),P("tbody",{},...e.map(r))),a=()=>({name:"hawser-inputs",columns:["input","value","origin","where from"].map(u=>({label:u})),rows:e}),l=e.filter(u=>u[2]==="estimated"||u[2]==="catalogue"),c=l.length>0?`Not from the case itself: ${l.length}. Check these first.`:"";return Rt("inputs",t,P("p",{},`${e.length} values: ${s}. ${c}`),P("details",{class:"long",open:e.length<=40},P("summary",{},"All values"),ey("Inputs",o)),Xi(a))},sy=({run:n,data:e,units:t})=>{let{summary:i}=n,s=a=>a==null||a===""?P("span",{},ai):ft(a),r=(a,l)=>Qe(i[a],l,t),o=[Dn("Case",s(i.case)),Dn("Results",s(n.label)),Dn("Simulated with",s(i.version&&`hawser ${i.version}`)),Dn("Report by",s(e.hawser&&`hawser ${e.hawser}`),e.generated?ft(e.generated):""),Dn("Simulated time",r("sim_time_s","s")),Dn("Segments",r("segments","1")),Dn("Steps",r("steps","1")),Dn("Computed in",r("wall_time_s","s")),Dn("Outcome",s(i.outcome),i.message?ft(i.message):"")];return Rt("about","Versions",P("dl",{class:"facts small"},...o))},ry=({run:n,units:e,store:t})=>{let i=n.summary.events??[];if(i.length===0)return null;let s=o=>()=>t.set("time",o),r=i.map(o=>P("li",{},P("button",{type:"button",class:"pick",onclick:s(o.time_s)},Qe(o.time_s,"s",e))," ",ft(kn(o.what,e)),o.pull_N===null?"":`, pull ${Qe(o.pull_N,"N",e)}`));return Rt("events","Events",P("ol",{class:"events"},...r))};var NC={key:"name",label:"piece"},DC=[{key:"from_m",label:"from",unit:"m"},{key:"to_m",label:"to",unit:"m"},{key:"angle_deg",label:"angle, \xB0"},{key:"radius_m",label:"R",unit:"m"},{key:"turns",label:"turns"},{key:"slope_deg",label:"slope, \xB0"},{key:"mu",label:"friction",unit:"1"},{key:"mu_rest",label:"at rest",unit:"1"}],oy=n=>[{key:`${n}_start_N`,label:"in",unit:"N"},{key:`${n}_end_N`,label:"out",unit:"N"},{key:`${n}_rest_N`,label:"from rest",unit:"N"},{key:`${n}_sidewall_N_per_m`,label:"T/R",unit:"N/m"}];function ay(n){let e=n.run.summary.pieces??[];if(e.length===0)return null;let t=e.map(s=>Object.fromEntries(Object.entries(s).map(([r,o])=>[r,o??""]))),i=(s,r,o)=>_r(s,r,t,[NC,...o],n.units);return Rt("pieces","The route piece by piece",pn("By theory, full of cable. \u201Cin\u201D and \u201Cout\u201D are tensions in motion; friction has the weight correction of ducts."),i("pieces","Pulled forward",[...DC,...oy("forward")]),i("pieces-back","Pulled back",[{key:"to_m",label:"from",unit:"m"},{key:"from_m",label:"to",unit:"m"},...oy("back")]))}var mp=12;function FC(n){let e=n.run.rollers,t=c=>yt(e,c)??[],[i,s,r,o]=[t("s_m"),t("steady_N"),t("peak_N"),t("rating_N")],a=pr(e,"name").map((c,u)=>{let[d,h]=[r[u]??null,o[u]??null],f=d===null||h===null||h<=0?null:d/h;return{index:u,name:c,place:i[u]??null,steady:s[u]??null,peak:d,rating:h,share:f}}),l=c=>c.share??-1;return a.sort((c,u)=>l(u)-l(c)||(u.peak??0)-(c.peak??0))}function ly(n,e,t){let{units:i,store:s}=e,r=n.share===null?"unjudged":n.share>1?"unsafe":"safe",o=n.share===null?ai:Qe(100*(1-n.share),"%",i,3),a=c=>P("td",{class:c===ai?"unknown":"number"},c),l=P("button",{type:"button",class:"pick",onclick:()=>s.set("roller",n.index),title:"Show in the 3-D view"},ft(n.name));return P("tr",{onmouseenter:()=>s.set("place",n.place),onmouseleave:()=>s.set("place",null)},P("th",{scope:"row"},l),a(n.place===null?"by coordinates":Qe(n.place,"m",i)),a(Qe(n.steady,"N",i)),a(Qe(n.peak,"N",i)),...t?[a(n.rating===null?"not given":Qe(n.rating,"N",i)),a(o),P("td",{class:"usage-cell"},n.share===null?null:Eh(n.share,r))]:[])}function cy(n){let e=FC(n);if(!n.run.rollers)return Rt("rollers","Rollers",pn("These results hold no loads of rollers."));if(e.length===0)return null;let t=e.some(p=>p.rating!==null),i=t?"The smallest margin of the peak load against the rating first.":"No roller has a rating in this case, so there are no margins. The largest load first.",s=P("tbody",{},...e.slice(0,mp).map(p=>ly(p,n,t))),r=e.length>mp?ei(`Show all ${e.length} rollers`,()=>{s.append(...e.slice(mp).map(p=>ly(p,n,t))),r?.remove()}):null,o=["Roller","Place","Steady mean","Peak",...t?["Rating","Margin of the peak","Used"]:[]],a=P("table",{class:"rollers"},P("caption",{},i),P("thead",{},P("tr",{},...o.map(p=>P("th",{scope:"col"},p)))),s),l=Mx(n.run),c=kt("N",n.units,1e3),u=kt("m",n.units,1),d=(p,v)=>p===null?null:p*v,h=()=>({name:"hawser-roller-margins",columns:[{label:"roller"},{label:"place",unit:u.symbol},...["steady mean","peak","rating"].map(p=>({label:p,unit:c.symbol})),{label:"margin"}],rows:e.map(p=>[p.name,d(p.place,u.factor),d(p.steady,c.factor),d(p.peak,c.factor),d(p.rating,c.factor),p.share===null?null:1-p.share])}),f=P("div",{class:"scroll",tabindex:0,role:"region","aria-label":"Rollers by margin"},a);return Rt("rollers","Rollers",l?n.figure(l):null,f,r,Xi(h))}var UC={safe:"SAFE",conditional:"SAFE ONLY IF",unsafe:"NOT SAFE",untrusted:"NOT TRUSTED",unjudged:"NOT JUDGED"},OC=new Set(["bend_radius","rope_bend","clearance"]);function kC(n,e){let{units:t}=e,i=$r(n),s=n.margin??0,r=s<0?`${Qe(-100*s,"%",t,3)} over`:`${Qe(100*s,"%",t,3)} left`,o=OC.has(n.name)?"at least ":"";return P("p",{},P("strong",{},Bn(n.name)),": ",P("strong",{},Qe(n.value,i,t)),n.where?" at ":"",n.where?ft(kn(n.where,t)):null,`. Allowed: ${o}${Qe(n.limit,i,t)}; `,P("strong",{},r),".")}function BC(n){let{run:e,units:t}=n,i=e.envelope?.place,s=i?.tension_max_N?{s:i.s_m,tension:i.tension_max_N,names:[]}:{s:yt(e.stations,"s_m")??[],tension:yt(e.stations,"peak_N")??[],names:pr(e.stations,"name")},r=hn(s.tension)?.[1];if(r===void 0)return P("p",{},"Where the tension is largest is not known.");let o=s.tension.indexOf(r),a=s.names[o];return P("p",{},P("strong",{},"Tension")," is largest at ",P("strong",{},Qe(s.s[o],"m",t)),a?" (":"",a?ft(a):null,a?")":""," along the route: ",P("strong",{},Qe(r,"N",t)),". No limit was judged.")}function VC(n){let e=pl(n.run),t=e.filter(s=>s.ok===!1),i=t.length>0?t:e.slice(0,1);return i.length>0?i.map(s=>kC(s,n)):[BC(n)]}var uy=n=>n.charAt(0).toUpperCase()+n.slice(1);function zC(n){let e=n.run.summary.remedies??[],t=e.flatMap(r=>typeof r!="string"&&r.limit==="all"?[r.text]:[]),i=e.flatMap(r=>typeof r=="string"?[r]:r.limit==="all"?[]:[r.text]);return t.length>0&&i.unshift(`${t.join(" and ")} would do, computed by theory with this run's figures: run the case again with it`),i.length>0?i.map(r=>P("p",{},ft(`${uy(kn(r,n.units))}.`))):pl(n.run).filter(r=>r.ok===!1).map(r=>{let o=kn(Y_(r),n.units)||`its figures alone do not tell what to change; the limit is from: ${r.source}`;return P("p",{},P("strong",{},Bn(r.name)),": ",ft(o),".")})}function GC(n){let{run:e}=n,t=e.summary;switch(ml(e)){case"untrusted":{let s=(t.trust??[]).filter(o=>o.holds===!1).map(o=>P("li",{},P("strong",{},Bn(o.name)),": ",ft(kn(o.remedy,n.units)))),r=P("p",{},"Make the figures trustworthy first; until then no margin on this page counts.");return s.length>0?[r,P("ul",{},...s)]:[r]}case"unsafe":return[...zC(n),P("p",{class:"detail"},"A remedy looks at its own limit alone: compute again with it.")];case"conditional":{let s=(t.limits??[]).filter(r=>[r.friction_most,r.friction_least,r.friction_at_rest_most,r.back_tension_most_N].some(o=>typeof o=="number")).map(r=>P("li",{},P("strong",{},Bn(r.name)),`: depends on ${r.assumed}, which the case does not give`));return[P("p",{},"Give or measure what is assumed, or change the pull until these limits hold:"),P("ul",{},...s)]}case"safe":{let i=(t.limits??[]).filter(r=>r.ok===null),s=i.map(r=>Bn(r.name).toLowerCase()).join(", ");return[P("p",{},"Nothing has to change: every limit that was judged holds."),...i.length>0?[P("p",{class:"detail"},`Not judged: ${s}. The table of limits says what is missing.`)]:[]]}default:{let i=(t.limits??[]).filter(r=>r.ok===null);if(i.length===0)return[P("p",{},"Say what the cable may bear: give the case a section \u201Climits\u201D, and compute again.")];let s=i.map(r=>P("li",{},P("strong",{},Bn(r.name)),": ",ft(kn(r.source,n.units))));return[P("p",{},"Give the case what is missing, and compute again:"),P("ul",{},...s)]}}}function HC(n){return uy(n.replace(/^(NOT SAFE|NOT TRUSTED|NOT JUDGED|SAFE ONLY IF|SAFE):?\s*/,""))}function hy(n){let{run:e,units:t}=n,{summary:i}=e,s=ml(e),r=i.verdict?HC(i.verdict):"These results hold no verdict: they are of an older hawser, or of a run that was cut short.",o=i.outcome==="running"?"The run has not ended, or was killed: this is what it had written by then.":i.outcome&&i.outcome!=="finished"?`The run ended early (${i.outcome}). ${i.message??""}`:"";return P("section",{id:"verdict",class:`verdict ${s}`,"aria-labelledby":"verdict-heading"},P("h2",{id:"verdict-heading"},gr(s),P("span",{},UC[s])),P("p",{class:"reason"},ft(kn(r,t))),o?P("p",{class:"reason"},ft(kn(o,t))):null,P("div",{class:"answers"},P("div",{},P("h3",{},"Where it is tightest"),...VC(n)),P("div",{},P("h3",{},"What to change"),...GC(n))))}function dy(n,e,t,i){let s=i.map(([r,o])=>{let a=P("input",{type:"radio",name:e,value:r,checked:n.get(e)===r,onchange:()=>n.set(e,r)});return n.subscribe(e,l=>a.checked=l===r),P("label",{},a,P("span",{},o))});return P("fieldset",{class:"choice"},P("legend",{},t),...s)}function fy(n,e){let t=dy(e,"units","Units",[["si","Metric"],["us","US"]]),i=dy(e,"theme","Colours",[["light","Light"],["dark","Dark"]]),s=P("div",{class:"toolbar",role:"toolbar","aria-label":"The page"});if(n.runs.length>1){let r=P("select",{id:"run-choice",onchange:()=>e.set("run",Number(r.value))});yl(n.runs).forEach((o,a)=>r.append(P("option",{value:a},o.slice(0,60)))),e.subscribe("run",o=>r.value=String(o)),s.append(P("label",{class:"run-choice"},"Run ",r))}return s.append(t,i,ei("Print",()=>print(),{class:"print"})),s}var WC=[hy,Gx,Ex,Xx,ay,kx,Bx],XC=[Vx,ry,cy,Zx,Kx,Jx,jx,ny,iy,sy],Nh=class{constructor(e,t,i){this.data=t;this.store=i;this.viewSection=P("section",{id:"view","aria-labelledby":"view-heading"},P("h2",{id:"view-heading"},"The pull in three dimensions"),this.viewRoot,this.viewPaper);let s=P("div",{class:"body"},this.before,this.viewSection,this.after);e.replaceChildren(fy(t,i),this.heading,P("div",{class:"columns"},this.contents,s));for(let r of["units","theme"])i.subscribe(r,()=>this.fill());i.subscribe("run",()=>{this.memory.clear(),this.fill(),this.mount()}),addEventListener("beforeprint",()=>this.print(!0)),addEventListener("afterprint",()=>this.print(!1)),this.fill(),Al(this.viewRoot,()=>this.mount())}data;store;figures=[];ends=[];memory=new Map;heading=P("header",{class:"page-head"});before=P("div");after=P("div");viewRoot=P("div",{class:"view"});viewPaper=P("div",{class:"on-paper"});viewSection;contents=P("nav",{class:"contents","aria-label":"Contents"});view=null;run(){let e=this.data.runs[this.store.get("run")]??this.data.runs[0];if(!e)throw new Error("The data of this page hold no run.");return e}context(){return{data:this.data,run:this.run(),store:this.store,units:this.store.get("units"),figure:e=>{let t=this.memory.get(e.id)??{zoom:null,hidden:new Set,open:!1};this.memory.set(e.id,t);let i=new bo(e,this.store,t);return this.figures.push(i),i.element},onDispose:e=>this.ends.push(e)}}fill(){for(let o of this.figures)o.dispose();for(let o of this.ends)o();this.figures=[],this.ends=[];let e=this.context(),{run:t}=e,i=[this.before,this.after].map(o=>[o,o.offsetHeight]);for(let[o,a]of i)o.style.minHeight=`${a}px`;let s=o=>o.map(a=>a(e)).filter(a=>a!==null);this.before.replaceChildren(...s(WC)),this.after.replaceChildren(...s(XC)),requestAnimationFrame(()=>i.forEach(([o])=>o.style.minHeight=""));let r=t.summary.version?`simulated with hawser ${t.summary.version}`:"";this.heading.replaceChildren(P("p",{class:"kind"},"Report of a cable pull"),P("h1",{},ft(sp(t))),P("p",{class:"by"},ft(t.summary.case??t.label),r?` \xB7 ${r}`:""),...(t.notes??[]).map(o=>P("p",{class:"note"},ft(o)))),document.title=`${sp(t).slice(0,120)} \xB7 hawser`,this.list()}list(){let t=[...document.querySelectorAll("main section[id]")].map(i=>{let s=i.id==="verdict"?"Verdict":i.querySelector("h2")?.textContent??"";return P("li",{},P("a",{href:`#${i.id}`},s))});this.contents.replaceChildren(P("ul",{},...t))}mount(){this.view?.dispose(),this.view=null;let e=this.run();if(!e.states&&!e.geometry){this.viewRoot.replaceChildren(pn("These results hold neither states of the cable nor the geometry of the route, so there is nothing to play."));return}try{this.view=Sh(this.viewRoot,e,this.store,Up(this.data.runs,e))}catch(t){let i=t instanceof Error?t.message:String(t);this.viewRoot.replaceChildren(pn(`The view could not be made here: ${i}`))}}print(e){for(let i of this.figures)i.print(e);let t=e?this.view?.onPaper()??null:null;this.viewPaper.replaceChildren(...t?[t]:[]);for(let i of document.querySelectorAll("details.long"))e&&(i.open=!0)}};function qC(n){let e=matchMedia("(prefers-color-scheme: dark)"),t=e.matches?"dark":"light",i=new Mo({place:null,time:null,units:"si",theme:t,run:0,roller:null}),s=()=>{document.documentElement.dataset.theme=i.get("theme")};s(),i.subscribe("theme",s),e.addEventListener("change",()=>i.set("theme",e.matches?"dark":"light")),new Nh(n,Op(document),i)}Object.assign(window,{hawserLive:_x});var gp=document.getElementById("hawser");if(gp)try{qC(gp)}catch(n){throw gp.replaceChildren(P("p",{class:"failed",role:"alert"},n instanceof Error?n.message:String(n))),n}})();
