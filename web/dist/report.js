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
"use strict";(()=>{function Wp(n,e){let t=(i,s)=>`${i.label}/${s}`;for(let i of n){let s=(i.summary.chains??[]).map(o=>o.name),r=n.filter(o=>o===i||s.some(a=>o.label===t(i,a)));if(r.length>1&&r.includes(e))return r.filter(o=>o!==e)}return[]}function Kh({geometry:n}){n&&!n.route.s_m&&(n.route={s_m:[],position_m:[],curvature_per_m:[]})}function Xp(n){let e=n.getElementById("hawser-data")?.textContent;if(!e)throw new Error("This page holds no data of a run.");let t=JSON.parse(e);if(t.format!==1)throw new Error(`The data of this page are of format ${String(t.format)}; the page reads 1.`);if(!Array.isArray(t.runs)||t.runs.length===0)throw new Error("The data of this page hold no run.");return t.runs.forEach(Kh),t}var ky="http://www.w3.org/2000/svg";function $p(n,e,t){for(let[i,s]of Object.entries(e))typeof s=="function"?n.addEventListener(i.slice(2),s):s===!0?n.setAttribute(i,""):s!==!1&&s!==null&&s!==void 0&&n.setAttribute(i,String(s));for(let i of t)i&&n.append(i)}function A(n,e={},...t){let i=document.createElement(n);return $p(i,e,t),i}function Qe(n,e={},...t){let i=document.createElementNS(ky,n);return $p(i,e,t),i}var qp=160;function ft(n){let e=n??"";return e.length<=qp?A("bdi",{class:"name"},e):A("bdi",{class:"name",title:e.slice(0,2e3)},`${e.slice(0,qp)}\u2026`)}function ni(n,e,t={}){return A("button",{type:"button",onclick:e,...t},n)}var By="400px 0px";var Vy=new Promise(n=>{setTimeout(n,1500),PerformanceObserver.supportedEntryTypes.includes("paint")&&new PerformanceObserver(()=>n()).observe({type:"paint",buffered:!0})}),Yp=n=>{"requestIdleCallback"in window?requestIdleCallback(n,{timeout:1500}):setTimeout(n,50)},pa=new Map,Zp=new IntersectionObserver(n=>n.forEach(e=>e.isIntersecting&&Kp(e.target)),{rootMargin:By}),Jh=!1;function Kp(n){let e=pa.get(n);Jp(n),e?.()}function Jp(n){pa.delete(n),Zp.unobserve(n)}function jp(){let[n]=pa.keys();Jh=n!==void 0,n&&(Kp(n),Yp(jp))}function Pl(n,e){return pa.set(n,e),Vy.then(()=>{pa.has(n)&&(Zp.observe(n),Jh||(Jh=!0,Yp(jp)))}),()=>Jp(n)}function zs(n){let e=new Set;for(let r of n)for(let o of r.x)o!==null&&Number.isFinite(o)&&e.add(o);let t=[...e].sort((r,o)=>r-o),i=new Map(t.map((r,o)=>[r,o])),s=n.map(r=>{let o=new Array(t.length).fill(void 0);return r.x.forEach((a,l)=>{let c=a===null?void 0:i.get(a);c!==void 0&&(o[c]=r.y[l]??null)}),o});return{x:t,y:s}}function zy(n,e){let t=0,i=n.length;for(;t<i;){let s=t+i>>1;n[s]<=e?t=s+1:i=s}return t-1}function ys(n,e,t){let i=zy(n,t);for(;i>=0&&e[i]===void 0;)i-=1;if(i<0)return null;let s=e[i];if(s==null)return null;let r=n[i];if(r===t)return s;let o=i+1;for(;o<n.length&&e[o]===void 0;)o+=1;let a=e[o];return a==null?null:s+(a-s)*(t-r)/(n[o]-r)}function jh(n,e,t){let i=null,s=1/0;return n.forEach((r,o)=>{let a=r===null?1/0:Math.abs(r-t);a<s&&e[o]!==null&&e[o]!==void 0&&(s=a,i=e[o])}),i}function dn(n){let e=1/0,t=-1/0;for(let i of n)i==null||!Number.isFinite(i)||(e=Math.min(e,i),t=Math.max(t,i));return e>t?null:[e,t]}var Il=4.4482216152605,Gy={N:[{symbol:"kN",factor:.001,from:1e3},{symbol:"N",factor:1,from:0}],"N/m":[{symbol:"kN/m",factor:.001,from:2e3},{symbol:"N/m",factor:1,from:0}],mm:[{symbol:"mm",factor:1e3,from:0}],"N m":[{symbol:"kN m",factor:.001,from:1e4},{symbol:"N m",factor:1,from:0}]},Hy={N:{symbol:"lbf",factor:1/Il},"N/m":{symbol:"lbf/ft",factor:.3048/Il},m:{symbol:"ft",factor:1/.3048},mm:{symbol:"in",factor:12/.3048},"m/s":{symbol:"ft/min",factor:60/.3048},"N m":{symbol:"lbf ft",factor:1/(Il*.3048)},W:{symbol:"ft lbf/s",factor:1/(Il*.3048)},"1/m":{symbol:"1/ft",factor:.3048}};function kt(n,e,t){let i=Hy[n];if(e==="us"&&i)return i;let r=Gy[n]?.find(({from:o})=>Math.abs(t)>=o);return r?{symbol:r.symbol,factor:r.factor}:{symbol:n==="1"?"":n,factor:1}}function ma(n){let[e="",t]=n.replace("-","\u2212").split("."),s=e.replace(/\D/g,"").length>4?e.replace(/\B(?=(\d{3})+$)/g,"\u202F"):e;return t?`${s}.${t}`:s}function fn(n,e=4){if(n===0)return"0";let t=Math.floor(Math.log10(Math.abs(n)));if(t<-5||t>8)return n.toExponential(e-1);let i=Math.max(0,e-1-t),s=n.toFixed(Math.min(i,12));return ma(s.includes(".")?s.replace(/\.?0+$/,""):s)}var ci="not known";function Ye(n,e,t,i=4){if(n==null||Number.isNaN(n))return ci;if(e==="%")return`${fn(n,i)}\u202F%`;let{symbol:s,factor:r}=kt(e,t,n);return s?`${fn(n*r,i)}\xA0${s}`:fn(n*r,i)}function Ll(n){return["N","N/m","m","mm","m/s","s","1","%","N m","W","rad/s","1/m"].includes(n)}var Wy=/(-?\d+(?:\.\d+)?(?:e[+-]?\d+)?)\s(kN\/m|N\/m|m\/s|kN m|N m|kN|mm|N|m)(?![\w/])/g,Xy={"kN/m":["N/m",1e3],"kN m":["N m",1e3],kN:["N",1e3],mm:["mm",.001]};function Bn(n,e){if(e==="si")return n;let t=(i,s,r)=>{let[o,a]=Xy[r]??[r,1];return Ye(Number(s)*a,o,e)};return n.split(/('[^']*')/).map((i,s)=>s%2===1?i:i.replace(Wy,t)).join("")}var qy={text:"#1b1f24",muted:"#57606a",grid:"#e3e7eb",paper:"#ffffff",limit:"#c04a00",event:"#7a5195",window:"rgba(0, 114, 178, 0.07)",band:"rgba(0, 114, 178, 0.16)",curve:{simulated:"#0072b2",peak:"#0072b2",envelope:"#5aa9d6",theory:"#1b1f24",backward:"#8a6d00",paper:"#b3437c",second:"#c98a00",third:"#007f5f",fourth:"#b3437c",fifth:"#3f8fc0",sixth:"#57606a",ground:"#57606a",route:"#1b1f24"}},$y={text:"#e6eaee",muted:"#9aa5b1",grid:"#2b323a",paper:"#161b21",limit:"#ff8a4c",event:"#c3a1dd",window:"rgba(86, 180, 233, 0.09)",band:"rgba(86, 180, 233, 0.22)",curve:{simulated:"#56b4e9",peak:"#56b4e9",envelope:"#3b7ea8",theory:"#e6eaee",backward:"#d9bf4d",paper:"#e39ac4",second:"#e69f00",third:"#2fc59a",fourth:"#e39ac4",fifth:"#8fc7ea",sixth:"#9aa5b1",ground:"#9aa5b1",route:"#e6eaee"}},Hi=n=>n==="dark"?$y:qy,lo={simulated:[],peak:[1,3],envelope:[],theory:[7,4],backward:[2,3],paper:[9,3,2,3],second:[6,3],third:[2,2],fourth:[9,3,2,3],fifth:[12,4],sixth:[4,2,1,2],ground:[],route:[]},co={simulated:2,peak:1.5,envelope:1,theory:1.5,backward:1.5,paper:1.5,second:1.5,third:1.5,fourth:1.5,fifth:1.5,sixth:1.5,ground:1.5,route:1.5},Gs=["simulated","second","third","fourth","fifth","sixth"];var Yy=2.5;function Ar(n){let e=Math.max(0,...n.curves.map(t=>dn(t.y)?.[1]??0));return(n.levels??[]).filter(({value:t})=>t<=Yy*e||e===0)}function Nl(n,e,t){let i=[e,t,...Ar(n).map(({value:l})=>l),...n.fromZero===!1?[]:[0]],s=Math.max(0,(n.span??0)-(Math.max(...i)-Math.min(...i)))/2,[r,o]=[Math.min(...i)-s,Math.max(...i)+s],a=(o-r||Math.abs(o)||1)*.06;return[r===0?0:r-a,o===0&&r<0?0:o+a]}function Qp(n,e,t,i){let s=(o,a)=>n.x[a]>=e&&n.x[a]<=t,r=n.y.flatMap((o,a)=>i.has(a)?[]:dn(o.filter(s))??[]);return dn(r)??[0,1]}function uo(n,e,t){let i=e-n;if(!(i>0))return[n];let s=i/Math.max(1,t),r=10**Math.floor(Math.log10(s)),o=[1,2,5,10].map(l=>l*r).find(l=>l>=s*.999)??s,a=[];for(let l=Math.ceil(n/o-1e-9);l*o<=e+1e-9*i;l+=1)a.push(l*o);return a}function ga(n){let e=n.length>1?Math.abs(n[1]-n[0]):1,t=Math.max(0,Math.min(8,-Math.floor(Math.log10(e)+1e-9)));return n.map(i=>ma(Math.abs(i)<e*1e-6?"0":i.toFixed(t)))}var Dl={place:"m",time:"s",head:"m"};function Zy(n,e){let t=Hi(e).curve[n.role],i=n.points?Qe("circle",{cx:13,cy:6,r:3,fill:Hi(e).paper,stroke:t,"stroke-width":1.5}):Qe("path",{d:"M1 6H25",stroke:t,"stroke-width":co[n.role],"stroke-dasharray":lo[n.role].join(" ")||null});return Qe("svg",{width:26,height:12,"aria-hidden":"true",class:"swatch"},i)}function em(n){return Qe("svg",{width:26,height:12,"aria-hidden":"true",class:"swatch"},Qe("rect",{x:2,y:1,width:22,height:10,fill:n}))}function Ky(n){return Qe("svg",{width:26,height:12,"aria-hidden":"true",class:"swatch"},Qe("path",{d:"M1 6H25",stroke:n,"stroke-width":2}))}function tm(n,e,t,i){let s=Hi(i.theme),r=A("span",{class:"legend-at"}),o=[],a=A("ul",{class:"legend","aria-label":"Curves"});n.curves.forEach((u,h)=>{if(u.quiet){o.push(null);return}let d=A("span",{class:"legend-value"});o.push(d);let f=!i.hidden.has(h),p=A("button",{type:"button",class:"legend-item","aria-pressed":String(f),onclick:()=>i.onToggle(h)},Zy(u,i.theme),A("bdi",{},u.label));a.append(A("li",{},p,d))}),n.band&&a.append(A("li",{},A("span",{class:"legend-item"},em(s.band),n.band.label)));let l=new Set(Ar(n));for(let u of n.levels??[]){let h=l.has(u)?"":" (above the figure)",d=`${u.label}: ${Ye(u.value,n.yUnit,i.units)}${h}`;a.append(A("li",{},A("span",{class:"legend-item"},Ky(s.limit),d)))}n.window&&a.append(A("li",{},A("span",{class:"legend-item"},em(s.window),n.window.label)));let c="";return{element:A("div",{class:"legend-row"},a,r),update(u){let h=[];n.curves.forEach((d,f)=>{let p=u===null?null:ys(e.x,e.y[f]??[],u),_=p===null?"":`${fn(p*t.factor)}\xA0${t.symbol}`.trim(),g=o[f];g&&(g.textContent=_),_&&g&&h.push(`${d.label} ${_}`)}),r.textContent=u===null?"":`at ${Ye(u,Dl[n.along],i.units)}`,c=u===null?"":`${r.textContent}: ${h.join(", ")||"nothing known"}`},sentence:()=>c}}function Fl(n,e){if(n.along==="place")return e.get("place");let t=e.get("time");return n.along==="time"||t===null?t:n.clock?jh(n.clock.time,n.clock.head,t):null}function ed(n,e,t,i){if(n.along==="place")e.set("place",t,i);else if(t!==null&&n.along==="time")e.set("time",t,i);else if(n.along==="head"){e.set("place",t,i);let s=t===null||!n.clock?null:jh(n.clock.head,n.clock.time,t);s!==null&&e.set("time",s,i)}}function nm(n,e){let{chart:t,xScale:i}=n,s=e===null?-10:t.valToPos(e*i.factor,"x"),r=s>=0&&s<=t.over.clientWidth;t.setCursor({left:r?s:-10,top:r?10:-10},!1)}function Qh(n,e,t,i){let s=Math.max(e[0],t-(t-n[0])*i),r=Math.min(e[1],t+(n[1]-t)*i);return r-s<(e[1]-e[0])*1e-4?n:[s,r]}function im(n,e){if(n.ctrlKey||n.metaKey||n.altKey)return;let t=e.view(),i=e.cursor()??(t[0]+t[1])/2,s=(t[1]-t[0])/100*(n.shiftKey?10:1),r=l=>Math.min(t[1],Math.max(t[0],l)),a={ArrowLeft:()=>e.move(r(i-s)),ArrowRight:()=>e.move(r(i+s)),Home:()=>e.move(t[0]),End:()=>e.move(t[1]),"+":()=>e.zoom(Qh(t,e.reach(),r(i),.5)),"=":()=>e.zoom(Qh(t,e.reach(),r(i),.5)),"-":()=>e.zoom(Qh(t,e.reach(),r(i),2)),0:()=>e.zoom(e.reach())}[n.key];a&&(n.preventDefault(),a())}var Jy="uplot",jy="u-hz",Qy="u-vt",ev="u-title",tv="u-wrap",nv="u-under",iv="u-over",sv="u-axis",Pr="u-off",rv="u-select",ov="u-cursor-x",av="u-cursor-y",lv="u-cursor-pt",cv="u-legend",uv="u-live",hv="u-inline",dv="u-series",fv="u-marker",sm="u-label",pv="u-value",xa="width",ya="height";var rm="bottom",ho="left",td="right",xd="#000",om=xd+"0",nd="mousemove",am="mousedown",id="mouseup",lm="mouseenter",cm="mouseleave",um="dblclick",mv="resize",gv="scroll",hm="change",Vl="dppxchange",yd="--",yo=typeof window<"u",ld=yo?document:null,po=yo?window:null,_v=yo?navigator:null,Rt,Ul;function cd(){let n=devicePixelRatio;Rt!=n&&(Rt=n,Ul&&hd(hm,Ul,cd),Ul=matchMedia(`(min-resolution: ${Rt-.001}dppx) and (max-resolution: ${Rt+.001}dppx)`),Ir(hm,Ul,cd),po.dispatchEvent(new CustomEvent(Vl)))}function yi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function ud(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Jt(n,e,t){n.style[e]=t+"px"}function Wi(n,e,t,i){let s=ld.createElement(n);return e!=null&&yi(s,e),t?.insertBefore(s,i),s}function Di(n,e){return Wi("div",n,e)}var dm=new WeakMap;function as(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=dm.get(n);r!=o&&(n.style.transform=r,dm.set(n,r),e<0||t<0||e>i||t>s?yi(n,Pr):ud(n,Pr))}var fm=new WeakMap;function pm(n,e,t){let i=e+t,s=fm.get(n);i!=s&&(fm.set(n,i),n.style.background=e,n.style.borderColor=t)}var mm=new WeakMap;function gm(n,e,t,i){let s=e+""+t,r=mm.get(n);s!=r&&(mm.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var vd={passive:!0},xv={...vd,capture:!0};function Ir(n,e,t,i){e.addEventListener(n,t,i?xv:vd)}function hd(n,e,t,i){e.removeEventListener(n,t,vd)}yo&&cd();function Xi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:vi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function Wm(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var Xm=n=>n!=null,qm=n=>n!=null&&n>0,Hl=Wm(Xm),yv=Wm(qm);function vv(n,e,t,i=0,s=!1){let r=s?yv:Hl,o=s?qm:Xm;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Wt,l??-Wt]}function Wl(n,e,t,i){let s=ym(n),r=ym(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?vs:$m,a=s==1?vi:Fi,l=r==1?Fi:vi,c=a(o(Sn(n))),u=l(o(Sn(e))),h=mo(t,c),d=mo(t,u);return t==10&&(c<0&&(h=Xt(h,-c)),u<0&&(d=Xt(d,-u))),i||t==2?(n=h*s,e=d*r):(n=Jm(n,h),e=Xl(e,d)),[n,e]}function bd(n,e,t,i){let s=Wl(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var Md=.1,_m={mode:3,pad:Md},ba={pad:0,soft:null,mode:0},bv={min:ba,max:ba};function zl(n,e,t,i){return ql(t)?xm(n,e,t):(ba.pad=t,ba.soft=i?0:null,ba.mode=i?3:0,xm(n,e,bv))}function St(n,e){return n??e}function Mv(n,e,t){for(e=St(e,0),t=St(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function xm(n,e,t){let i=t.min,s=t.max,r=St(i.pad,0),o=St(s.pad,0),a=St(i.hard,-Wt),l=St(s.hard,Wt),c=St(i.soft,Wt),u=St(s.soft,-Wt),h=St(i.mode,0),d=St(s.mode,0),f=e-n,p=vs(f),_=ii(Sn(n),Sn(e)),g=vs(_),m=Sn(g-p);(f<1e-24||m>10)&&(f=0,(n==0||e==0)&&(f=1e-24,h==2&&c!=Wt&&(r=0),d==2&&u!=-Wt&&(o=0)));let S=f||_||1e3,C=vs(S),b=mo(10,vi(C)),R=S*(f==0?n==0?.1:1:r),T=Xt(Jm(n-R,b/10),24),N=n>=c&&(h==1||h==3&&T<=c||h==2&&T>=c)?c:Wt,v=ii(a,T<N&&n>=N?N:qi(N,T)),E=S*(f==0?e==0?.1:1:o),F=Xt(Xl(e+E,b/10),24),I=e<=u&&(d==1||d==3&&F>=u||d==2&&F<=u)?u:-Wt,U=qi(l,F>I&&e<=I?I:ii(I,F));return v==U&&v==0&&(U=100),[v,U]}var Sv=new Intl.NumberFormat(yo?_v.language:"en-US"),Sd=n=>Sv.format(n),bi=Math,Bl=bi.PI,Sn=bi.abs,vi=bi.floor,Mn=bi.round,Fi=bi.ceil,qi=bi.min,ii=bi.max,mo=bi.pow,ym=bi.sign,vs=bi.log10,$m=bi.log2,wv=(n,e=1)=>bi.sinh(n)*e,sd=(n,e=1)=>bi.asinh(n/e),Wt=1/0;function vm(n){return(vs((n^n>>31)-(n>>31))|0)+1}function dd(n,e,t){return qi(ii(n,e),t)}function Ym(n){return typeof n=="function"}function _t(n){return Ym(n)?n:()=>n}var Tv=()=>{},Zm=n=>n,Km=(n,e)=>e,Ev=n=>null,bm=n=>!0,Mm=(n,e)=>n==e,Av=/\.\d*?(?=9{6,}|0{6,})/gm,Lr=n=>{if(Qm(n)||Ws.has(n))return n;let e=`${n}`,t=e.match(Av);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Lr(s)}e${r}`}return Xt(n,i)};function Cr(n,e){return Lr(Xt(Lr(n/e))*e)}function Xl(n,e){return Lr(Fi(Lr(n/e))*e)}function Jm(n,e){return Lr(vi(Lr(n/e))*e)}function Xt(n,e=0){if(Qm(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Mn(i)/t}var Ws=new Map;function jm(n){return((""+n).split(".")[1]||"").length}function Sa(n,e,t,i){let s=[],r=i.map(jm);for(let o=e;o<t;o++){let a=Sn(o),l=Xt(mo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:Xt(u,h);s.push(d),Ws.set(d,h)}}return s}var Ma={},wd=[],go=[null,null],Hs=Array.isArray,Qm=Number.isInteger,Cv=n=>n===void 0;function Sm(n){return typeof n=="string"}function ql(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Rv(n){return n!=null&&typeof n=="object"}var Pv=Object.getPrototypeOf(Uint8Array),eg="__proto__";function _o(n,e=ql){let t;if(Hs(n)){let i=n.find(s=>s!=null);if(Hs(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=_o(n[s],e)}else t=n.slice()}else if(n instanceof Pv)t=n.slice();else if(e(n)){t={};for(let i in n)i!=eg&&(t[i]=_o(n[i],e))}else t=n;return t}function xn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=eg&&(ql(n[s])?xn(n[s],_o(i[s])):n[s]=_o(i[s]))}return n}var Iv=0,Lv=1,Nv=2;function Dv(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function Fv(n,e){if(kv(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Bv(o[0])||(o=Ov(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=e?e[o][c]:Lv,f=[];for(let p=0;p<u.length;p++){let _=u[p],g=r.get(l[p]);_===null?d!=Iv&&(h[g]=_,d==Nv&&f.push(g)):h[g]=_}Dv(h,f,s),i.push(h)}}return i}var Uv=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Ov(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function kv(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Bv(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=ii(1,vi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var tg=["January","February","March","April","May","June","July","August","September","October","November","December"],ng=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function ig(n){return n.slice(0,3)}var Vv=ng.map(ig),zv=tg.map(ig),Gv={MMMM:tg,MMM:zv,WWWW:ng,WWW:Vv};function _a(n){return(n<10?"0":"")+n}function Hv(n){return(n<10?"00":n<100?"0":"")+n}var Wv={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>_a(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>_a(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>_a(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>_a(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>_a(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Hv(n.getMilliseconds())};function Td(n,e){e=e||Gv;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?Wv[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var Xv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function qv(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==Xv?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var sg=n=>n%1==0,Gl=[1,2,2.5,5],$v=Sa(10,-32,0,Gl),rg=Sa(10,0,32,Gl),Yv=rg.filter(sg),Rr=$v.concat(rg),Ed=`
`,og="{YYYY}",wm=Ed+og,ag="{M}/{D}",va=Ed+ag,Ol=va+"/{YY}",lg="{aa}",Zv="{h}:{mm}",fo=Zv+lg,Tm=Ed+fo,Em=":{ss}",Lt=null;function cg(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Sa(10,0,3,Gl).filter(sg):Sa(10,-3,0,Gl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,og,Lt,Lt,Lt,Lt,Lt,Lt,1],[s*28,"{MMM}",wm,Lt,Lt,Lt,Lt,Lt,1],[s,ag,wm,Lt,Lt,Lt,Lt,Lt,1],[i,"{h}"+lg,Ol,Lt,va,Lt,Lt,Lt,1],[t,fo,Ol,Lt,va,Lt,Lt,Lt,1],[e,Em,Ol+" "+fo,Lt,va+" "+fo,Lt,Tm,Lt,1],[n,Em+".{fff}",Ol+" "+fo,Lt,va+" "+fo,Lt,Tm,Lt,1]];function u(h){return(d,f,p,_,g,m)=>{let S=[],C=g>=o,b=g>=r&&g<o,R=h(p),T=Xt(R*n,3),N=rd(R.getFullYear(),C?0:R.getMonth(),b||C?1:R.getDate()),v=Xt(N*n,3);if(b||C){let E=b?g/r:0,F=C?g/o:0,I=T==v?T:Xt(rd(N.getFullYear()+F,N.getMonth()+E,1)*n,3),U=new Date(Mn(I/n)),k=U.getFullYear(),X=U.getMonth();for(let O=0;I<=_;O++){let $=rd(k+F*O,X+E*O,1),H=$-h(Xt($*n,3));I=Xt((+$+H)*n,3),I<=_&&S.push(I)}}else{let E=g>=s?s:g,F=vi(p)-vi(T),I=v+F+Xl(T-v,E);S.push(I);let U=h(I),k=U.getHours()+U.getMinutes()/t+U.getSeconds()/i,X=g/i,O=d.axes[f]._space,$=m/O;for(;I=Xt(I+g,n==1?0:3),!(I>_);)if(X>1){let H=vi(Xt(k+X,6))%24,le=h(I).getHours()-H;le>1&&(le=-1),I-=le*i,k=(k+X)%24;let de=S[S.length-1];Xt((I-de)/g,3)*$>=.7&&S.push(I)}else S.push(I)}return S}}return[l,c,u]}var[Kv,Jv,jv]=cg(1),[Qv,eb,tb]=cg(.001);Sa(2,-53,53,[1]);function Am(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Cm(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,u,h,d,f;return i.map(p=>{let _=n(p),g=_.getFullYear(),m=_.getMonth(),S=_.getDate(),C=_.getHours(),b=_.getMinutes(),R=_.getSeconds(),T=g!=l&&a[2]||m!=c&&a[3]||S!=u&&a[4]||C!=h&&a[5]||b!=d&&a[6]||R!=f&&a[7]||a[1];return l=g,c=m,u=S,h=C,d=b,f=R,T(_)})}}function nb(n,e){let t=Td(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function rd(n,e,t){return new Date(n,e,t)}function Rm(n,e){return e(n)}var ib="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Pm(n,e){return(t,i,s,r)=>r==null?yd:e(n(i))}function sb(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function rb(n,e){return n.series[e].fill(n,e)}var ob={show:!0,live:!0,isolate:!1,mount:Tv,markers:{show:!0,width:2,stroke:sb,fill:rb,dash:"solid"},idx:null,idxs:null,values:[]};function ab(n,e){let t=n.cursor.points,i=Di(),s=t.size(n,e);Jt(i,xa,s),Jt(i,ya,s);let r=s/-2;Jt(i,"marginLeft",r),Jt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Jt(i,"borderWidth",o),i}function lb(n,e){let t=n.series[e].points;return t._fill||t._stroke}function cb(n,e){let t=n.series[e].points;return t._stroke||t._fill}function ub(n,e){return n.series[e].points.size}var od=[0,0];function hb(n,e,t){return od[0]=e,od[1]=t,od}function kl(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function ad(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var db={show:!0,x:!0,y:!0,lock:!1,move:hb,points:{one:!1,show:ab,size:ub,width:0,stroke:cb,fill:lb},bind:{mousedown:kl,mouseup:kl,click:kl,dblclick:kl,mousemove:ad,mouseleave:ad,mouseenter:ad},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},ug={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Ad=xn({},ug,{filter:Km}),hg=xn({},Ad,{size:10}),dg=xn({},ug,{show:!1}),Cd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',fg="bold "+Cd,pg=1.5,Im={show:!0,scale:"x",stroke:xd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:fg,side:2,grid:Ad,ticks:hg,border:dg,font:Cd,lineGap:pg,rotate:0},fb="Value",pb="Time",Lm={show:!0,scale:"x",auto:!1,sorted:1,min:Wt,max:-Wt,idxs:[]};function mb(n,e,t,i,s){return e.map(r=>r==null?"":Sd(r))}function gb(n,e,t,i,s,r,o){let a=[],l=Ws.get(s)||0;t=o?t:Xt(Xl(t,s),l);for(let c=t;c<=i;c=Xt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function fd(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?vs:$m,u=vi(c(t));s=mo(l,u),l==10&&(s=Rr[Xi(s,Rr)]);let h=t,d=s*l;l==10&&(d=Rr[Xi(d,Rr)]);do a.push(h),h=h+s,l==10&&!Ws.has(h)&&(h=Xt(h,Ws.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=Rr[Xi(d,Rr)]));while(h<=i);return a}function _b(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?fd(n,e,ii(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?fd(n,e,ii(l,-i),-t,s):[l]).reverse().map(d=>-d).concat(u,c)}var mg=/./,xb=/[12357]/,yb=/[125]/,Nm=/1/,pd=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function vb(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?mg:l(7,o)-u>=c?xb:l(5,o)-u>=c?yb:Nm;if(h==Nm){let d=Sn(l(1,o)-u);if(d<c)return pd(e.slice().reverse(),a.distr,h,Fi(c/d)).reverse()}return pd(e,a.distr,h,1)}function bb(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=Sn(l(1,o)-l(2,o));return c<a?pd(e.slice().reverse(),3,mg,Fi(a/c)).reverse():e}function Mb(n,e,t,i){return i==null?yd:e==null?"":Sd(e)}var Dm={show:!0,scale:"y",stroke:xd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:fg,side:3,grid:Ad,ticks:hg,border:dg,font:Cd,lineGap:pg,rotate:0};function Sb(n,e){let t=3+(n||1)*2;return Xt(t*e,3)}function wb(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=Sn(o-r),l=n.series[e],c=a/(l.points.space*Rt);return i[1]-i[0]<=c}var Fm={scale:null,auto:!0,sorted:0,min:Wt,max:-Wt},gg=(n,e,t,i,s)=>s,Um={show:!0,auto:!0,sorted:0,gaps:gg,alpha:1,facets:[xn({},Fm,{scale:"x"}),xn({},Fm,{scale:"y"})]},Om={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:gg,alpha:1,points:{show:wb,filter:null},values:null,min:Wt,max:-Wt,idxs:[],path:null,clip:null};function Tb(n,e,t,i,s){return t/10}var _g={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Eb=xn({},_g,{time:!1,ori:1}),km={};function xg(n,e){let t=km[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(km[n]=t)),t}var xo=1,md=2;function Nr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,_=a.height,g=n.valToPosH,m=n.valToPosV;return u.ori==0?t(s,l,c,u,h,g,m,d,f,p,_,Yl,vo,Kl,vg,Mg):t(s,l,c,u,h,m,g,f,d,_,p,Zl,bo,Id,bg,Sg)}function Rd(n,e){let t=0,i=0,s=St(n.bands,wd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function Ab(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function bs(n,e,t,i,s,r){return Nr(n,e,(o,a,l,c,u,h,d,f,p,_,g)=>{let m=o.pxRound,S=c.dir*(c.ori==0?1:-1),C=c.ori==0?vo:bo,b,R;S==1?(b=t,R=i):(b=i,R=t);let T=m(h(a[b],c,_,f)),N=m(d(l[b],u,g,p)),v=m(h(a[R],c,_,f)),E=m(d(r==1?u.max:u.min,u,g,p)),F=new Path2D(s);return C(F,v,E),C(F,T,E),C(F,T,N),F})}function $l(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Kl:Id,l=t;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function Cb(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Pd(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(n[h]),p=d==h?f:r(n[d]),_=h-s;f=o<=0&&_>=0&&_<l?r(n[_]):f;let m=d+s;p=o>=0&&m>=0&&m<l?r(n[m]):p,p>=f&&a.push([f,p])}return a}function Bm(n){return n==0?Zm:n==1?Mn:e=>Cr(e,n)}function yg(n){let e=n==0?Yl:Zl,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=qi(c,a/2,l/2),u=qi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Yl=(n,e,t)=>{n.moveTo(e,t)},Zl=(n,e,t)=>{n.moveTo(t,e)},vo=(n,e,t)=>{n.lineTo(e,t)},bo=(n,e,t)=>{n.lineTo(t,e)},Kl=yg(0),Id=yg(1),vg=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},bg=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},Mg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Sg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function wg(n){return(e,t,i,s,r)=>Nr(e,t,(o,a,l,c,u,h,d,f,p,_,g)=>{let{pxRound:m,points:S}=o,C,b;c.ori==0?(C=Yl,b=vg):(C=Zl,b=bg);let R=Xt(S.width*Rt,3),T=(S.size-S.width)/2*Rt,N=Xt(T*2,3),v=new Path2D,E=new Path2D,{left:F,top:I,width:U,height:k}=e.bbox;Kl(E,F-N,I-N,U+N*2,k+N*2);let X=O=>{if(l[O]!=null){let $=m(h(a[O],c,_,f)),H=m(d(l[O],u,g,p));C(v,$+T,H),b(v,$,H,T,0,Bl*2)}};if(r)r.forEach(X);else for(let O=i;O<=s;O++)X(O);return{stroke:R>0?v:null,fill:v,clip:E,flags:xo|md}})}function Tg(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var Rb=Tg(vo),Pb=Tg(bo);function Eg(n){let e=St(n?.alignGaps,0);return(t,i,s,r)=>Nr(t,i,(o,a,l,c,u,h,d,f,p,_,g)=>{[s,r]=Hl(l,s,r);let m=o.pxRound,S=k=>m(h(k,c,_,f)),C=k=>m(d(k,u,g,p)),b,R;c.ori==0?(b=vo,R=Rb):(b=bo,R=Pb);let T=c.dir*(c.ori==0?1:-1),N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:xo},v=N.stroke,E=!1;if(r-s>=_*4){let k=_e=>t.posToVal(_e,c.key,!0),X=null,O=null,$,H,ie,oe=S(a[T==1?s:r]),le=S(a[s]),de=S(a[r]),ue=k(T==1?le+1:de-1);for(let _e=T==1?s:r;_e>=s&&_e<=r;_e+=T){let st=a[_e],Q=(T==1?st<ue:st>ue)?oe:S(st),ae=l[_e];Q==oe?ae!=null?(H=ae,X==null?(b(v,Q,C(H)),$=X=O=H):H<X?X=H:H>O&&(O=H)):ae===null&&(E=!0):(X!=null&&R(v,oe,C(X),C(O),C($),C(H)),ae!=null?(H=ae,b(v,Q,C(H)),X=O=$=H):(X=O=null,ae===null&&(E=!0)),oe=Q,ue=k(oe+T))}X!=null&&X!=O&&ie!=oe&&R(v,oe,C(X),C(O),C($),C(H))}else for(let k=T==1?s:r;k>=s&&k<=r;k+=T){let X=l[k];X===null?E=!0:X!=null&&b(v,S(a[k]),C(X))}let[I,U]=Rd(t,i);if(o.fill!=null||I!=0){let k=N.fill=new Path2D(v),X=o.fillTo(t,i,o.min,o.max,I),O=C(X),$=S(a[s]),H=S(a[r]);T==-1&&([H,$]=[$,H]),b(k,H,O),b(k,$,O)}if(!o.spanGaps){let k=[];E&&k.push(...Pd(a,l,s,r,T,S,e)),N.gaps=k=o.gaps(t,i,s,r,k),N.clip=$l(k,c.ori,f,p,_,g)}return U!=0&&(N.band=U==2?[bs(t,i,s,r,v,-1),bs(t,i,s,r,v,1)]:bs(t,i,s,r,v,U)),N})}function Ib(n){let e=St(n.align,1),t=St(n.ascDesc,!1),i=St(n.alignGaps,0),s=St(n.extend,!1);return(r,o,a,l)=>Nr(r,o,(c,u,h,d,f,p,_,g,m,S,C)=>{[a,l]=Hl(h,a,l);let b=c.pxRound,{left:R,width:T}=r.bbox,N=le=>b(p(le,d,S,g)),v=le=>b(_(le,f,C,m)),E=d.ori==0?vo:bo,F={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:xo},I=F.stroke,U=d.dir*(d.ori==0?1:-1),k=v(h[U==1?a:l]),X=N(u[U==1?a:l]),O=X,$=X;s&&e==-1&&($=R,E(I,$,k)),E(I,X,k);for(let le=U==1?a:l;le>=a&&le<=l;le+=U){let de=h[le];if(de==null)continue;let ue=N(u[le]),_e=v(de);e==1?E(I,ue,k):E(I,O,_e),E(I,ue,_e),k=_e,O=ue}let H=O;s&&e==1&&(H=R+T,E(I,H,k));let[ie,oe]=Rd(r,o);if(c.fill!=null||ie!=0){let le=F.fill=new Path2D(I),de=c.fillTo(r,o,c.min,c.max,ie),ue=v(de);E(le,H,ue),E(le,$,ue)}if(!c.spanGaps){let le=[];le.push(...Pd(u,h,a,l,U,N,i));let de=c.width*Rt/2,ue=t||e==1?de:-de,_e=t||e==-1?-de:de;le.forEach(st=>{st[0]+=ue,st[1]+=_e}),F.gaps=le=c.gaps(r,o,a,l,le),F.clip=$l(le,d.ori,g,m,S,C)}return oe!=0&&(F.band=oe==2?[bs(r,o,a,l,I,-1),bs(r,o,a,l,I,1)]:bs(r,o,a,l,I,oe)),F})}function Vm(n,e,t,i,s,r,o=Wt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Sn(n[l]-n[a]);u<c&&(c=u,o=Sn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function Lb(n){n=n||Ma;let e=St(n.size,[.6,Wt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=_t(s),o=1-e[0],a=St(e[1],Wt),l=St(e[2],1),c=St(n.disp,Ma),u=St(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,p,_,g)=>Nr(f,p,(m,S,C,b,R,T,N,v,E,F,I)=>{let U=m.pxRound,k=t,X=i*Rt,O=a*Rt,$=l*Rt,H,ie;b.ori==0?[H,ie]=r(f,p):[ie,H]=r(f,p);let oe=b.dir*(b.ori==0?1:-1),le=b.ori==0?Kl:Id,de=b.ori==0?u:(fe,P,y,q,K,ee,me)=>{u(fe,P,y,K,q,me,ee)},ue=St(f.bands,wd).find(fe=>fe.series[0]==p),_e=ue!=null?ue.dir:0,st=m.fillTo(f,p,m.min,m.max,_e),et=U(N(st,R,I,E)),Q,ae,he,Ve=F,De=U(m.width*Rt),ke=!1,Tt=null,Ze=null,mt=null,ct=null;h!=null&&(De==0||d!=null)&&(ke=!0,Tt=h.values(f,p,_,g),Ze=new Map,new Set(Tt).forEach(fe=>{fe!=null&&Ze.set(fe,new Path2D)}),De>0&&(mt=d.values(f,p,_,g),ct=new Map,new Set(mt).forEach(fe=>{fe!=null&&ct.set(fe,new Path2D)})));let{x0:ot,size:qt}=c;if(ot!=null&&qt!=null){k=1,S=ot.values(f,p,_,g),ot.unit==2&&(S=S.map(y=>f.posToVal(v+y*F,b.key,!0)));let fe=qt.values(f,p,_,g);qt.unit==2?ae=fe[0]*F:ae=T(fe[0],b,F,v)-T(0,b,F,v),Ve=Vm(S,C,T,b,F,v,Ve),he=Ve-ae+X}else Ve=Vm(S,C,T,b,F,v,Ve),he=Ve*o+X,ae=Ve-he;he<1&&(he=0),De>=ae/2&&(De=0),he<5&&(U=Zm);let tn=he>0,$t=Ve-he-(tn?De:0);ae=U(dd($t,$,O)),Q=(k==0?ae/2:k==oe?0:ae)-k*oe*((k==0?X/2:0)+(tn?De/2:0));let bt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Ut=ke?null:new Path2D,It=null;if(ue!=null)It=f.data[ue.series[1]];else{let{y0:fe,y1:P}=c;fe!=null&&P!=null&&(C=P.values(f,p,_,g),It=fe.values(f,p,_,g))}let G=H*ae,We=ie*ae;for(let fe=oe==1?_:g;fe>=_&&fe<=g;fe+=oe){let P=C[fe];if(P==null)continue;if(It!=null){let ne=It[fe]??0;if(P-ne==0)continue;et=N(ne,R,I,E)}let y=b.distr!=2||c!=null?S[fe]:fe,q=T(y,b,F,v),K=N(St(P,st),R,I,E),ee=U(q-Q),me=U(ii(K,et)),ge=U(qi(K,et)),te=me-ge;if(P!=null){let ne=P<0?We:G,xe=P<0?G:We;ke?(De>0&&mt[fe]!=null&&le(ct.get(mt[fe]),ee,ge+vi(De/2),ae,ii(0,te-De),ne,xe),Tt[fe]!=null&&le(Ze.get(Tt[fe]),ee,ge+vi(De/2),ae,ii(0,te-De),ne,xe)):le(Ut,ee,ge+vi(De/2),ae,ii(0,te-De),ne,xe),de(f,p,fe,ee-De/2,ge,ae+De,te)}}return De>0?bt.stroke=ke?ct:Ut:ke||(bt._fill=m.width==0?m._fill:m._stroke??m._fill,bt.width=0),bt.fill=ke?Ze:Ut,bt})}function Nb(n,e){let t=St(e?.alignGaps,0);return(i,s,r,o)=>Nr(i,s,(a,l,c,u,h,d,f,p,_,g,m)=>{[r,o]=Hl(c,r,o);let S=a.pxRound,C=H=>S(d(H,u,g,p)),b=H=>S(f(H,h,m,_)),R,T,N;u.ori==0?(R=Yl,N=vo,T=Mg):(R=Zl,N=bo,T=Sg);let v=u.dir*(u.ori==0?1:-1),E=C(l[v==1?r:o]),F=E,I=[],U=[];for(let H=v==1?r:o;H>=r&&H<=o;H+=v)if(c[H]!=null){let oe=l[H],le=C(oe);I.push(F=le),U.push(b(c[H]))}let k={stroke:n(I,U,R,N,T,S),fill:null,clip:null,band:null,gaps:null,flags:xo},X=k.stroke,[O,$]=Rd(i,s);if(a.fill!=null||O!=0){let H=k.fill=new Path2D(X),ie=a.fillTo(i,s,a.min,a.max,O),oe=b(ie);N(H,F,oe),N(H,E,oe)}if(!a.spanGaps){let H=[];H.push(...Pd(l,c,r,o,v,C,t)),k.gaps=H=a.gaps(i,s,r,o,H),k.clip=$l(H,u.ori,p,_,g,m)}return $!=0&&(k.band=$==2?[bs(i,s,r,o,X,-1),bs(i,s,r,o,X,1)]:bs(i,s,r,o,X,$)),k})}function Db(n){return Nb(Fb,n)}function Fb(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=e[d+1]-e[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,e[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,e[d+1]-l[d+1]*h[d]/3,n[d+1],e[d+1])}return a}var gd=new Set;function zm(){for(let n of gd)n.syncRect(!0)}yo&&(Ir(mv,po,zm),Ir(gv,po,zm,!0),Ir(Vl,po,()=>{wn.pxRatio=Rt}));var Ub=Eg(),Ob=wg();function Gm(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>_d(r,o,e,t))}function kb(n,e){return n.map((t,i)=>i==0?{}:xn({},e,t))}function _d(n,e,t,i){return xn({},e==0?t:i,n)}function Ag(n,e,t){return e==null?go:[e,t]}var Bb=Ag;function Vb(n,e,t){return e==null?go:zl(e,t,Md,!0)}function Cg(n,e,t,i){return e==null?go:Wl(e,t,n.scales[i].log,!1)}var zb=Cg;function Rg(n,e,t,i){return e==null?go:bd(e,t,n.scales[i].log,!1)}var Gb=Rg;function Hb(n,e,t,i,s){let r=ii(vm(n),vm(e)),o=e-n,a=Xi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Ws.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Hm(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Mn((t=+s)*Rt))+"px"),[n,e,t]}function Wb(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Xt(e[2]*Rt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function wn(n,e,t){let i={mode:St(n.mode,1)},s=i.mode;function r(x,M,L,D){let B=M.valToPct(x);return D+L*(M.dir==-1?1-B:B)}function o(x,M,L,D){let B=M.valToPct(x);return D+L*(M.dir==-1?B:1-B)}function a(x,M,L,D){return M.ori==0?r(x,M,L,D):o(x,M,L,D)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Di(Jy);if(n.id!=null&&(c.id=n.id),yi(c,n.class),n.title){let x=Di(ev,c);x.textContent=n.title}let u=Wi("canvas"),h=i.ctx=u.getContext("2d"),d=Di(tv,c);Ir("click",d,x=>{x.target===p&&(Yt!=io||sn!=so)&&kn.click(i,x)},!0);let f=i.under=Di(nv,d);d.appendChild(u);let p=i.over=Di(iv,d);n=_o(n);let _=+St(n.pxAlign,1),g=Bm(_);(n.plugins||[]).forEach(x=>{x.opts&&(n=x.opts(i,n)||n)});let m=n.ms||.001,S=i.series=s==1?Gm(n.series||[],Lm,Om,!1):kb(n.series||[null],Um),C=i.axes=Gm(n.axes||[],Im,Dm,!0),b=i.scales={},R=i.bands=n.bands||[];R.forEach(x=>{x.fill=_t(x.fill||null),x.dir=St(x.dir,-1)});let T=s==2?S[1].facets[0].scale:S[0].scale,N={axes:zt,series:Ot},v=(n.drawOrder||["axes","series"]).map(x=>N[x]);function E(x){let M=x.distr==3?L=>vs(L>0?L:x.clamp(i,L,x.min,x.max,x.key)):x.distr==4?L=>sd(L,x.asinh):x.distr==100?L=>x.fwd(L):L=>L;return L=>{let D=M(L),{_min:B,_max:Z}=x,re=Z-B;return(D-B)/re}}function F(x){let M=b[x];if(M==null){let L=(n.scales||Ma)[x]||Ma;if(L.from!=null){F(L.from);let D=xn({},b[L.from],L,{key:x});D.valToPct=E(D),b[x]=D}else{M=b[x]=xn({},x==T?_g:Eb,L),M.key=x;let D=M.time,B=M.range,Z=Hs(B);if((x!=T||s==2&&!D)&&(Z&&(B[0]==null||B[1]==null)&&(B={min:B[0]==null?_m:{mode:1,hard:B[0],soft:B[0]},max:B[1]==null?_m:{mode:1,hard:B[1],soft:B[1]}},Z=!1),!Z&&ql(B))){let re=B;B=(pe,ye,Re)=>ye==null?go:zl(ye,Re,re)}M.range=_t(B||(D?Bb:x==T?M.distr==3?zb:M.distr==4?Gb:Ag:M.distr==3?Cg:M.distr==4?Rg:Vb)),M.auto=_t(Z?!1:M.auto),M.clamp=_t(M.clamp||Tb),M._min=M._max=null,M.valToPct=E(M)}}}F("x"),F("y"),s==1&&S.forEach(x=>{F(x.scale)}),C.forEach(x=>{F(x.scale)});for(let x in n.scales)F(x);let I=b[T],U=I.distr,k,X;I.ori==0?(yi(c,jy),k=r,X=o):(yi(c,Qy),k=o,X=r);let O={};for(let x in b){let M=b[x];(M.min!=null||M.max!=null)&&(O[x]={min:M.min,max:M.max},M.min=M.max=null)}let $=n.tzDate||(x=>new Date(Mn(x/m))),H=n.fmtDate||Td,ie=m==1?jv($):tb($),oe=Cm($,Am(m==1?Jv:eb,H)),le=Pm($,Rm(ib,H)),de=[],ue=i.legend=xn({},ob,n.legend),_e=i.cursor=xn({},db,{drag:{y:s==2}},n.cursor),st=ue.show,et=_e.show,Q=ue.markers;ue.idxs=de,Q.width=_t(Q.width),Q.dash=_t(Q.dash),Q.stroke=_t(Q.stroke),Q.fill=_t(Q.fill);let ae,he,Ve,De=[],ke=[],Tt,Ze=!1,mt={};if(ue.live){let x=S[1]?S[1].values:null;Ze=x!=null,Tt=Ze?x(i,1,0):{_:0};for(let M in Tt)mt[M]=yd}if(st)if(ae=Wi("table",cv,c),Ve=Wi("tbody",null,ae),ue.mount(i,ae),Ze){he=Wi("thead",null,ae,Ve);let x=Wi("tr",null,he);Wi("th",null,x);for(var ct in Tt)Wi("th",sm,x).textContent=ct}else yi(ae,hv),ue.live&&yi(ae,uv);let ot={show:!0},qt={show:!1};function tn(x,M){if(M==0&&(Ze||!ue.live||s==2))return go;let L=[],D=Wi("tr",dv,Ve,Ve.childNodes[M]);yi(D,x.class),x.show||yi(D,Pr);let B=Wi("th",null,D);if(Q.show){let pe=Di(fv,B);if(M>0){let ye=Q.width(i,M);ye&&(pe.style.border=ye+"px "+Q.dash(i,M)+" "+Q.stroke(i,M)),pe.style.background=Q.fill(i,M)}}let Z=Di(sm,B);x.label instanceof HTMLElement?Z.appendChild(x.label):Z.textContent=x.label,M>0&&(Q.show||(Z.style.color=x.width>0?Q.stroke(i,M):Q.fill(i,M)),bt("click",B,pe=>{if(_e._lock)return;Ne(pe);let ye=S.indexOf(x);if((pe.ctrlKey||pe.metaKey)!=ue.isolate){let Re=S.some((Le,Fe)=>Fe>0&&Fe!=ye&&Le.show);S.forEach((Le,Fe)=>{Fe>0&&is(Fe,Re?Fe==ye?ot:qt:ot,!0,_n.setSeries)})}else is(ye,{show:!x.show},!0,_n.setSeries)},!1),Un&&bt(lm,B,pe=>{_e._lock||(Ne(pe),is(S.indexOf(x),oo,!0,_n.setSeries))},!1));for(var re in Tt){let pe=Wi("td",pv,D);pe.textContent="--",L.push(pe)}return[D,L]}let $t=new Map;function bt(x,M,L,D=!0){let B=$t.get(M)||{},Z=_e.bind[x](i,M,L,D);Z&&(Ir(x,M,B[x]=Z),$t.set(M,B))}function Ut(x,M,L){let D=$t.get(M)||{};for(let B in D)(x==null||B==x)&&(hd(B,M,D[B]),delete D[B]);x==null&&$t.delete(M)}let It=0,G=0,We=0,fe=0,P=0,y=0,q=P,K=y,ee=We,me=fe,ge=0,te=0,ne=0,xe=0;i.bbox={};let Be=!1,Me=!1,ve=!1,Oe=!1,Xe=!1,qe=!1;function V(x,M,L){(L||x!=i.width||M!=i.height)&&be(x,M),jn(!1),ve=!0,Me=!0,eo()}function be(x,M){i.width=It=We=x,i.height=G=fe=M,P=y=0,ce(),ze();let L=i.bbox;ge=L.left=Cr(P*Rt,.5),te=L.top=Cr(y*Rt,.5),ne=L.width=Cr(We*Rt,.5),xe=L.height=Cr(fe*Rt,.5)}let se=3;function Se(){let x=!1,M=0;for(;!x;){M++;let L=ln(M),D=ns(M);x=M==se||L&&D,x||(be(i.width,i.height),Me=!0)}}function Ae({width:x,height:M}){V(x,M)}i.setSize=Ae;function ce(){let x=!1,M=!1,L=!1,D=!1;C.forEach((B,Z)=>{if(B.show&&B._show){let{side:re,_size:pe}=B,ye=re%2,Re=B.label!=null?B.labelSize:0,Le=pe+Re;Le>0&&(ye?(We-=Le,re==3?(P+=Le,D=!0):L=!0):(fe-=Le,re==0?(y+=Le,x=!0):M=!0))}}),Zn[0]=x,Zn[1]=L,Zn[2]=M,Zn[3]=D,We-=fi[1]+fi[3],P+=fi[3],fe-=fi[2]+fi[0],y+=fi[0]}function ze(){let x=P+We,M=y+fe,L=P,D=y;function B(Z,re){switch(Z){case 1:return x+=re,x-re;case 2:return M+=re,M-re;case 3:return L-=re,L+re;case 0:return D-=re,D+re}}C.forEach((Z,re)=>{if(Z.show&&Z._show){let pe=Z.side;Z._pos=B(pe,Z._size),Z.label!=null&&(Z._lpos=B(pe,Z.labelSize))}})}if(_e.dataIdx==null){let x=_e.hover,M=x.skip=new Set(x.skip??[]);M.add(void 0);let L=x.prox=_t(x.prox),D=x.bias??=0;_e.dataIdx=(B,Z,re,pe)=>{if(Z==0)return re;let ye=re,Re=L(B,Z,re,pe)??Wt,Le=Re>=0&&Re<Wt,Fe=I.ori==0?We:fe,nt=_e.left,Ct=e[0],Mt=e[Z];if(M.has(Mt[re])){ye=null;let dt=null,Ke=null,He;if(D==0||D==-1)for(He=re;dt==null&&He-- >0;)M.has(Mt[He])||(dt=He);if(D==0||D==1)for(He=re;Ke==null&&He++<Mt.length;)M.has(Mt[He])||(Ke=He);if(dt!=null||Ke!=null)if(Le){let Kt=dt==null?-1/0:k(Ct[dt],I,Fe,0),un=Ke==null?1/0:k(Ct[Ke],I,Fe,0),Nn=nt-Kt,Gt=un-nt;Nn<=Gt?Nn<=Re&&(ye=dt):Gt<=Re&&(ye=Ke)}else ye=Ke==null?dt:dt==null?Ke:re-dt<=Ke-re?dt:Ke}else Le&&Sn(nt-k(Ct[re],I,Fe,0))>Re&&(ye=null);return ye}}let Ne=x=>{_e.event=x};_e.idxs=de,_e._lock=!1;let lt=_e.points;lt.show=_t(lt.show),lt.size=_t(lt.size),lt.stroke=_t(lt.stroke),lt.width=_t(lt.width),lt.fill=_t(lt.fill);let ht=i.focus=xn({},n.focus||{alpha:.3},_e.focus),Un=ht.prox>=0,On=Un&&lt.one,li=[],Ds=[],_s=[];function jr(x,M){let L=lt.show(i,M);if(L instanceof HTMLElement)return yi(L,lv),yi(L,x.class),as(L,-10,-10,We,fe),p.insertBefore(L,li[M]),L}function wl(x,M){if(s==1||M>0){let L=s==1&&b[x.scale].time,D=x.value;x.value=L?Sm(D)?Pm($,Rm(D,H)):D||le:D||Mb,x.label=x.label||(L?pb:fb)}if(On||M>0){x.width=x.width==null?1:x.width,x.paths=x.paths||Ub||Ev,x.fillTo=_t(x.fillTo||Ab),x.pxAlign=+St(x.pxAlign,_),x.pxRound=Bm(x.pxAlign),x.stroke=_t(x.stroke||null),x.fill=_t(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let L=Sb(ii(1,x.width),1),D=x.points=xn({},{size:L,width:ii(1,L*.2),stroke:x.stroke,space:L*2,paths:Ob,_stroke:null,_fill:null},x.points);D.show=_t(D.show),D.filter=_t(D.filter),D.fill=_t(D.fill),D.stroke=_t(D.stroke),D.paths=_t(D.paths),D.pxAlign=x.pxAlign}if(st){let L=tn(x,M);De.splice(M,0,L[0]),ke.splice(M,0,L[1]),ue.values.push(null)}if(et){de.splice(M,0,null);let L=null;On?M==0&&(L=jr(x,M)):M>0&&(L=jr(x,M)),li.splice(M,0,L),Ds.splice(M,0,0),_s.splice(M,0,0)}Ln("addSeries",M)}function Tl(x,M){M=M??S.length,x=s==1?_d(x,M,Lm,Om):_d(x,M,{},Um),S.splice(M,0,x),wl(S[M],M)}i.addSeries=Tl;function El(x){if(S.splice(x,1),st){ue.values.splice(x,1),ke.splice(x,1);let M=De.splice(x,1)[0];Ut(null,M.firstChild),M.remove()}et&&(de.splice(x,1),li.splice(x,1)[0].remove(),Ds.splice(x,1),_s.splice(x,1)),Ln("delSeries",x)}i.delSeries=El;let Zn=[!1,!1,!1,!1];function oa(x,M){if(x._show=x.show,x.show){let L=x.side%2,D=b[x.scale];D==null&&(x.scale=L?S[1].scale:T,D=b[x.scale]);let B=D.time;x.size=_t(x.size),x.space=_t(x.space),x.rotate=_t(x.rotate),Hs(x.incrs)&&x.incrs.forEach(re=>{!Ws.has(re)&&Ws.set(re,jm(re))}),x.incrs=_t(x.incrs||(D.distr==2?Yv:B?m==1?Kv:Qv:Rr)),x.splits=_t(x.splits||(B&&D.distr==1?ie:D.distr==3?fd:D.distr==4?_b:gb)),x.stroke=_t(x.stroke),x.grid.stroke=_t(x.grid.stroke),x.ticks.stroke=_t(x.ticks.stroke),x.border.stroke=_t(x.border.stroke);let Z=x.values;x.values=Hs(Z)&&!Hs(Z[0])?_t(Z):B?Hs(Z)?Cm($,Am(Z,H)):Sm(Z)?nb($,Z):Z||oe:Z||mb,x.filter=_t(x.filter||(D.distr>=3&&D.log==10?vb:D.distr==3&&D.log==2?bb:Km)),x.font=Hm(x.font),x.labelFont=Hm(x.labelFont),x._size=x.size(i,null,M,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(Zn[M]=!0,x._el=Di(sv,d))}}function Fs(x,M,L,D){let[B,Z,re,pe]=L,ye=M%2,Re=0;return ye==0&&(pe||Z)&&(Re=M==0&&!B||M==2&&!re?Mn(Im.size/3):0),ye==1&&(B||re)&&(Re=M==1&&!Z||M==3&&!pe?Mn(Dm.size/2):0),Re}let aa=i.padding=(n.padding||[Fs,Fs,Fs,Fs]).map(x=>_t(St(x,Fs))),fi=i._padding=aa.map((x,M)=>x(i,M,Zn,0)),gn,on=null,pn=null,Mr=s==1?S[0].idxs:null,pi=null,Sr=!1;function Al(x,M){if(e=x??[],i.data=i._data=e,s==2){gn=0;for(let L=1;L<S.length;L++)gn+=e[L][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),pi=e[0],gn=pi.length;let L=e;if(U==2){L=e.slice();let D=L[0]=Array(gn);for(let B=0;B<gn;B++)D[B]=B}i._data=e=L}if(jn(!0),Ln("setData"),U==2&&(ve=!0),M!==!1){let L=I;L.auto(i,Sr)?la():ks(T,L.min,L.max),Oe=Oe||_e.left>=0,qe=!0,eo()}}i.setData=Al;function la(){Sr=!0;let x,M;s==1&&(gn>0?(on=Mr[0]=0,pn=Mr[1]=gn-1,x=e[0][on],M=e[0][pn],U==2?(x=on,M=pn):x==M&&(U==3?[x,M]=Wl(x,x,I.log,!1):U==4?[x,M]=bd(x,x,I.log,!1):I.time?M=x+Mn(86400/m):[x,M]=zl(x,M,Md,!0))):(on=Mr[0]=x=null,pn=Mr[1]=M=null)),ks(T,x,M)}let w,W,j,Y,J,Te,Pe,we,Ue,Ce;function tt(x,M,L,D,B,Z){x??=om,L??=wd,D??="butt",B??=om,Z??="round",x!=w&&(h.strokeStyle=w=x),B!=W&&(h.fillStyle=W=B),M!=j&&(h.lineWidth=j=M),Z!=J&&(h.lineJoin=J=Z),D!=Te&&(h.lineCap=Te=D),L!=Y&&h.setLineDash(Y=L)}function rt(x,M,L,D){M!=W&&(h.fillStyle=W=M),x!=Pe&&(h.font=Pe=x),L!=we&&(h.textAlign=we=L),D!=Ue&&(h.textBaseline=Ue=D)}function Ge(x,M,L,D,B=0){if(D.length>0&&x.auto(i,Sr)&&(M==null||M.min==null)){let Z=St(on,0),re=St(pn,D.length-1),pe=L.min==null?vv(D,Z,re,B,x.distr==3):[L.min,L.max];x.min=qi(x.min,L.min=pe[0]),x.max=ii(x.max,L.max=pe[1])}}let Et={min:null,max:null};function an(){for(let D in b){let B=b[D];O[D]==null&&(B.min==null||O[T]!=null&&B.auto(i,Sr))&&(O[D]=Et)}for(let D in b){let B=b[D];O[D]==null&&B.from!=null&&O[B.from]!=null&&(O[D]=Et)}O[T]!=null&&jn(!0);let x={};for(let D in O){let B=O[D];if(B!=null){let Z=x[D]=_o(b[D],Rv);if(B.min!=null)xn(Z,B);else if(D!=T||s==2)if(gn==0&&Z.from==null){let re=Z.range(i,null,null,D);Z.min=re[0],Z.max=re[1]}else Z.min=Wt,Z.max=-Wt}}if(gn>0){S.forEach((D,B)=>{if(s==1){let Z=D.scale,re=O[Z];if(re==null)return;let pe=x[Z];if(B==0){let ye=pe.range(i,pe.min,pe.max,Z);pe.min=ye[0],pe.max=ye[1],on=Xi(pe.min,e[0]),pn=Xi(pe.max,e[0]),pn-on>1&&(e[0][on]<pe.min&&on++,e[0][pn]>pe.max&&pn--),D.min=pi[on],D.max=pi[pn]}else D.show&&D.auto&&Ge(pe,re,D,e[B],D.sorted);D.idxs[0]=on,D.idxs[1]=pn}else if(B>0&&D.show&&D.auto){let[Z,re]=D.facets,pe=Z.scale,ye=re.scale,[Re,Le]=e[B],Fe=x[pe],nt=x[ye];Fe!=null&&Ge(Fe,O[pe],Z,Re,Z.sorted),nt!=null&&Ge(nt,O[ye],re,Le,re.sorted),D.min=re.min,D.max=re.max}});for(let D in x){let B=x[D],Z=O[D];if(B.from==null&&(Z==null||Z.min==null)){let re=B.range(i,B.min==Wt?null:B.min,B.max==-Wt?null:B.max,D);B.min=re[0],B.max=re[1]}}}for(let D in x){let B=x[D];if(B.from!=null){let Z=x[B.from];if(Z.min==null)B.min=B.max=null;else{let re=B.range(i,Z.min,Z.max,D);B.min=re[0],B.max=re[1]}}}let M={},L=!1;for(let D in x){let B=x[D],Z=b[D];if(Z.min!=B.min||Z.max!=B.max){Z.min=B.min,Z.max=B.max;let re=Z.distr;Z._min=re==3?vs(Z.min):re==4?sd(Z.min,Z.asinh):re==100?Z.fwd(Z.min):Z.min,Z._max=re==3?vs(Z.max):re==4?sd(Z.max,Z.asinh):re==100?Z.fwd(Z.max):Z.max,M[D]=L=!0}}if(L){S.forEach((D,B)=>{s==2?B>0&&M.y&&(D._paths=null):M[D.scale]&&(D._paths=null)});for(let D in M)ve=!0,Ln("setScale",D);et&&_e.left>=0&&(Oe=qe=!0)}for(let D in O)O[D]=null}function nn(x){let M=dd(on-1,0,gn-1),L=dd(pn+1,0,gn-1);for(;x[M]==null&&M>0;)M--;for(;x[L]==null&&L<gn-1;)L++;return[M,L]}function Ot(){if(gn>0){let x=S.some(M=>M._focus)&&Ce!=ht.alpha;x&&(h.globalAlpha=Ce=ht.alpha),S.forEach((M,L)=>{if(L>0&&M.show&&(bn(L,!1),bn(L,!0),M._paths==null)){let D=Ce;Ce!=M.alpha&&(h.globalAlpha=Ce=M.alpha);let B=s==2?[0,e[L][0].length-1]:nn(e[L]);M._paths=M.paths(i,L,B[0],B[1]),Ce!=D&&(h.globalAlpha=Ce=D)}}),S.forEach((M,L)=>{if(L>0&&M.show){let D=Ce;Ce!=M.alpha&&(h.globalAlpha=Ce=M.alpha),M._paths!=null&&Ie(L,!1);{let B=M._paths!=null?M._paths.gaps:null,Z=M.points.show(i,L,on,pn,B),re=M.points.filter(i,L,Z,B);(Z||re)&&(M.points._paths=M.points.paths(i,L,on,pn,re),Ie(L,!0))}Ce!=D&&(h.globalAlpha=Ce=D),Ln("drawSeries",L)}}),x&&(h.globalAlpha=Ce=1)}}function bn(x,M){let L=M?S[x].points:S[x];L._stroke=L.stroke(i,x),L._fill=L.fill(i,x)}function Ie(x,M){let L=M?S[x].points:S[x],{stroke:D,fill:B,clip:Z,flags:re,_stroke:pe=L._stroke,_fill:ye=L._fill,_width:Re=L.width}=L._paths;Re=Xt(Re*Rt,3);let Le=null,Fe=Re%2/2;M&&ye==null&&(ye=Re>0?"#fff":pe);let nt=L.pxAlign==1&&Fe>0;if(nt&&h.translate(Fe,Fe),!M){let Ct=ge-Re/2,Mt=te-Re/2,dt=ne+Re,Ke=xe+Re;Le=new Path2D,Le.rect(Ct,Mt,dt,Ke)}M?zn(pe,Re,L.dash,L.cap,ye,D,B,re,Z):Kn(x,pe,Re,L.dash,L.cap,ye,D,B,re,Le,Z),nt&&h.translate(-Fe,-Fe)}function Kn(x,M,L,D,B,Z,re,pe,ye,Re,Le){let Fe=!1;ye!=0&&R.forEach((nt,Ct)=>{if(nt.series[0]==x){let Mt=S[nt.series[1]],dt=e[nt.series[1]],Ke=(Mt._paths||Ma).band;Hs(Ke)&&(Ke=nt.dir==1?Ke[0]:Ke[1]);let He,Kt=null;Mt.show&&Ke&&Mv(dt,on,pn)?(Kt=nt.fill(i,Ct)||Z,He=Mt._paths.clip):Ke=null,zn(M,L,D,B,Kt,re,pe,ye,Re,Le,He,Ke),Fe=!0}}),Fe||zn(M,L,D,B,Z,re,pe,ye,Re,Le)}let gt=xo|md;function zn(x,M,L,D,B,Z,re,pe,ye,Re,Le,Fe){tt(x,M,L,D,B),(ye||Re||Fe)&&(h.save(),ye&&h.clip(ye),Re&&h.clip(Re)),Fe?(pe&gt)==gt?(h.clip(Fe),Le&&h.clip(Le),mi(B,re),Jn(x,Z,M)):pe&md?(mi(B,re),h.clip(Fe),Jn(x,Z,M)):pe&xo&&(h.save(),h.clip(Fe),Le&&h.clip(Le),mi(B,re),h.restore(),Jn(x,Z,M)):(mi(B,re),Jn(x,Z,M)),(ye||Re||Fe)&&h.restore()}function Jn(x,M,L){L>0&&(M instanceof Map?M.forEach((D,B)=>{h.strokeStyle=w=B,h.stroke(D)}):M!=null&&x&&h.stroke(M))}function mi(x,M){M instanceof Map?M.forEach((L,D)=>{h.fillStyle=W=D,h.fill(L)}):M!=null&&x&&h.fill(M)}function Us(x,M,L,D){let B=C[x],Z;if(D<=0)Z=[0,0];else{let re=B._space=B.space(i,x,M,L,D),pe=B._incrs=B.incrs(i,x,M,L,D,re);Z=Hb(M,L,pe,D,re)}return B._found=Z}function At(x,M,L,D,B,Z,re,pe,ye,Re){let Le=re%2/2;_==1&&h.translate(Le,Le),tt(pe,re,ye,Re,pe),h.beginPath();let Fe,nt,Ct,Mt,dt=B+(D==0||D==3?-Z:Z);L==0?(nt=B,Mt=dt):(Fe=B,Ct=dt);for(let Ke=0;Ke<x.length;Ke++)M[Ke]!=null&&(L==0?Fe=Ct=x[Ke]:nt=Mt=x[Ke],h.moveTo(Fe,nt),h.lineTo(Ct,Mt));h.stroke(),_==1&&h.translate(-Le,-Le)}function ln(x){let M=!0;return C.forEach((L,D)=>{if(!L.show)return;let B=b[L.scale];if(B.min==null){L._show&&(M=!1,L._show=!1,jn(!1));return}else L._show||(M=!1,L._show=!0,jn(!1));let Z=L.side,re=Z%2,{min:pe,max:ye}=B,[Re,Le]=Us(D,pe,ye,re==0?We:fe);if(Le==0)return;let Fe=B.distr==2,nt=L._splits=L.splits(i,D,pe,ye,Re,Le,Fe),Ct=B.distr==2?nt.map(He=>pi[He]):nt,Mt=B.distr==2?pi[nt[1]]-pi[nt[0]]:Re,dt=L._values=L.values(i,L.filter(i,Ct,D,Le,Mt),D,Le,Mt);L._rotate=Z==2?L.rotate(i,dt,D,Le):0;let Ke=L._size;L._size=Fi(L.size(i,dt,D,x)),Ke!=null&&L._size!=Ke&&(M=!1)}),M}function ns(x){let M=!0;return aa.forEach((L,D)=>{let B=L(i,D,Zn,x);B!=fi[D]&&(M=!1),fi[D]=B}),M}function zt(){for(let x=0;x<C.length;x++){let M=C[x];if(!M.show||!M._show)continue;let L=M.side,D=L%2,B,Z,re=M.stroke(i,x),pe=L==0||L==3?-1:1,[ye,Re]=M._found;if(M.label!=null){let ei=M.labelGap*pe,xi=Mn((M._lpos+ei)*Rt);rt(M.labelFont[0],re,"center",L==2?"top":rm),h.save(),D==1?(B=Z=0,h.translate(xi,Mn(te+xe/2)),h.rotate((L==3?-Bl:Bl)/2)):(B=Mn(ge+ne/2),Z=xi);let Er=Ym(M.label)?M.label(i,x,ye,Re):M.label;h.fillText(Er,B,Z),h.restore()}if(Re==0)continue;let Le=b[M.scale],Fe=D==0?ne:xe,nt=D==0?ge:te,Ct=M._splits,Mt=Le.distr==2?Ct.map(ei=>pi[ei]):Ct,dt=Le.distr==2?pi[Ct[1]]-pi[Ct[0]]:ye,Ke=M.ticks,He=M.border,Kt=Ke.show?Ke.size:0,un=Mn(Kt*Rt),Nn=Mn((M.alignTo==2?M._size-Kt-M.gap:M.gap)*Rt),Gt=M._rotate*-Bl/180,hn=g(M._pos*Rt),gi=(un+Nn)*pe,Qn=hn+gi;Z=D==0?Qn:0,B=D==1?Qn:0;let Li=M.font[0],zi=M.align==1?ho:M.align==2?td:Gt>0?ho:Gt<0?td:D==0?"center":L==3?td:ho,rs=Gt||D==1?"middle":L==2?"top":rm;rt(Li,re,zi,rs);let _i=M.font[1]*M.lineGap,Ni=Ct.map(ei=>g(a(ei,Le,Fe,nt))),Gi=M._values;for(let ei=0;ei<Gi.length;ei++){let xi=Gi[ei];if(xi!=null){D==0?B=Ni[ei]:Z=Ni[ei],xi=""+xi;let Er=xi.indexOf(`
`)==-1?[xi]:xi.split(/\n/gm);for(let ti=0;ti<Er.length;ti++){let Hp=Er[ti];Gt?(h.save(),h.translate(B,Z+ti*_i),h.rotate(Gt),h.fillText(Hp,0,0),h.restore()):h.fillText(Hp,B,Z+ti*_i)}}}Ke.show&&At(Ni,Ke.filter(i,Mt,x,Re,dt),D,L,hn,un,Xt(Ke.width*Rt,3),Ke.stroke(i,x),Ke.dash,Ke.cap);let os=M.grid;os.show&&At(Ni,os.filter(i,Mt,x,Re,dt),D,D==0?2:1,D==0?te:ge,D==0?xe:ne,Xt(os.width*Rt,3),os.stroke(i,x),os.dash,os.cap),He.show&&At([hn],[1],D==0?1:0,D==0?1:2,D==1?te:ge,D==1?xe:ne,Xt(He.width*Rt,3),He.stroke(i,x),He.dash,He.cap)}Ln("drawAxes")}function jn(x){S.forEach((M,L)=>{L>0&&(M._paths=null,x&&(s==1?(M.min=null,M.max=null):M.facets.forEach(D=>{D.min=null,D.max=null})))})}let Vi=!1,Qr=!1,ca=[];function wy(){Qr=!1;for(let x=0;x<ca.length;x++)Ln(...ca[x]);ca.length=0}function eo(){Vi||(Uv(Tp),Vi=!0)}function Ty(x,M=!1){Vi=!0,Qr=M,x(i),Tp(),M&&ca.length>0&&queueMicrotask(wy)}i.batch=Ty;function Tp(){if(Be&&(an(),Be=!1),ve&&(Se(),ve=!1),Me){if(Jt(f,ho,P),Jt(f,"top",y),Jt(f,xa,We),Jt(f,ya,fe),Jt(p,ho,P),Jt(p,"top",y),Jt(p,xa,We),Jt(p,ya,fe),Jt(d,xa,It),Jt(d,ya,G),u.width=Mn(It*Rt),u.height=Mn(G*Rt),C.forEach(({_el:x,_show:M,_size:L,_pos:D,side:B})=>{if(x!=null)if(M){let Z=B===3||B===0?L:0,re=B%2==1;Jt(x,re?"left":"top",D-Z),Jt(x,re?"width":"height",L),Jt(x,re?"top":"left",re?y:P),Jt(x,re?"height":"width",re?fe:We),ud(x,Pr)}else yi(x,Pr)}),w=W=j=J=Te=Pe=we=Ue=Y=null,Ce=1,da(!0),P!=q||y!=K||We!=ee||fe!=me){jn(!1);let x=We/ee,M=fe/me;if(et&&!Oe&&_e.left>=0){_e.left*=x,_e.top*=M,to&&as(to,Mn(_e.left),0,We,fe),no&&as(no,0,Mn(_e.top),We,fe);for(let L=0;L<li.length;L++){let D=li[L];D!=null&&(Ds[L]*=x,_s[L]*=M,as(D,Fi(Ds[L]),Fi(_s[L]),We,fe))}}if(Zt.show&&!Xe&&Zt.left>=0&&Zt.width>0){Zt.left*=x,Zt.width*=x,Zt.top*=M,Zt.height*=M;for(let L in qh)Jt(ro,L,Zt[L])}q=P,K=y,ee=We,me=fe}Ln("setSize"),Me=!1}It>0&&G>0&&(h.clearRect(0,0,u.width,u.height),Ln("drawClear"),v.forEach(x=>x()),Ln("draw")),Zt.show&&Xe&&(Cl(Zt),Xe=!1),et&&Oe&&(Tr(null,!0,!1),Oe=!1),ue.show&&ue.live&&qe&&(Wh(),qe=!1),l||(l=!0,i.status=1,Ln("ready")),Sr=!1,Vi=!1}i.redraw=(x,M)=>{ve=M||!1,x!==!1?ks(T,I.min,I.max):eo()};function zh(x,M){let L=b[x];if(L.from==null){if(gn==0){let D=L.range(i,M.min,M.max,x);M.min=D[0],M.max=D[1]}if(M.min>M.max){let D=M.min;M.min=M.max,M.max=D}if(gn>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;x==T&&L.distr==2&&gn>0&&(M.min=Xi(M.min,e[0]),M.max=Xi(M.max,e[0]),M.min==M.max&&M.max++),O[x]=M,Be=!0,eo()}}i.setScale=zh;let Gh,Hh,to,no,Ep,Ap,io,so,Cp,Rp,Yt,sn,Os=!1,kn=_e.drag,Pn=kn.x,In=kn.y;et&&(_e.x&&(Gh=Di(ov,p)),_e.y&&(Hh=Di(av,p)),I.ori==0?(to=Gh,no=Hh):(to=Hh,no=Gh),Yt=_e.left,sn=_e.top);let Zt=i.select=xn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),ro=Zt.show?Di(rv,Zt.over?p:f):null;function Cl(x,M){if(Zt.show){for(let L in x)Zt[L]=x[L],L in qh&&Jt(ro,L,x[L]);M!==!1&&Ln("setSelect")}}i.setSelect=Cl;function Ey(x){if(S[x].show)st&&ud(De[x],Pr);else if(st&&yi(De[x],Pr),et){let L=On?li[0]:li[x];L!=null&&as(L,-10,-10,We,fe)}}function ks(x,M,L){zh(x,{min:M,max:L})}function is(x,M,L,D){M.focus!=null&&Iy(x),M.show!=null&&S.forEach((B,Z)=>{Z>0&&(x==Z||x==null)&&(B.show=M.show,Ey(Z),s==2?(ks(B.facets[0].scale,null,null),ks(B.facets[1].scale,null,null)):ks(B.scale,null,null),eo())}),L!==!1&&Ln("setSeries",x,M),D&&fa("setSeries",i,x,M)}i.setSeries=is;function Ay(x,M){xn(R[x],M)}function Cy(x,M){x.fill=_t(x.fill||null),x.dir=St(x.dir,-1),M=M??R.length,R.splice(M,0,x)}function Ry(x){x==null?R.length=0:R.splice(x,1)}i.addBand=Cy,i.setBand=Ay,i.delBand=Ry;function Py(x,M){S[x].alpha=M,et&&li[x]!=null&&(li[x].style.opacity=M),st&&De[x]&&(De[x].style.opacity=M)}let xs,Bs,wr,oo={focus:!0};function Iy(x){if(x!=wr){let M=x==null,L=ht.alpha!=1;S.forEach((D,B)=>{if(s==1||B>0){let Z=M||B==0||B==x;D._focus=M?null:Z,L&&Py(B,Z?1:ht.alpha)}}),wr=x,L&&eo()}}st&&Un&&bt(cm,ae,x=>{_e._lock||(Ne(x),wr!=null&&is(null,oo,!0,_n.setSeries))});function ss(x,M,L){let D=b[M];L&&(x=x/Rt-(D.ori==1?y:P));let B=We;D.ori==1&&(B=fe,x=B-x),D.dir==-1&&(x=B-x);let Z=D._min,re=D._max,pe=x/B,ye=Z+(re-Z)*pe,Re=D.distr;return Re==3?mo(10,ye):Re==4?wv(ye,D.asinh):Re==100?D.bwd(ye):ye}function Ly(x,M){let L=ss(x,T,M);return Xi(L,e[0],on,pn)}i.valToIdx=x=>Xi(x,e[0]),i.posToIdx=Ly,i.posToVal=ss,i.valToPos=(x,M,L)=>b[M].ori==0?r(x,b[M],L?ne:We,L?ge:0):o(x,b[M],L?xe:fe,L?te:0),i.setCursor=(x,M,L)=>{Yt=x.left,sn=x.top,Tr(null,M,L)};function Pp(x,M){Jt(ro,ho,Zt.left=x),Jt(ro,xa,Zt.width=M)}function Ip(x,M){Jt(ro,"top",Zt.top=x),Jt(ro,ya,Zt.height=M)}let ua=I.ori==0?Pp:Ip,ha=I.ori==1?Pp:Ip;function Ny(){if(st&&ue.live)for(let x=s==2?1:0;x<S.length;x++){if(x==0&&Ze)continue;let M=ue.values[x],L=0;for(let D in M)ke[x][L++].firstChild.nodeValue=M[D]}}function Wh(x,M){if(x!=null&&(x.idxs?x.idxs.forEach((L,D)=>{de[D]=L}):Cv(x.idx)||de.fill(x.idx),ue.idx=de[0]),st&&ue.live){for(let L=0;L<S.length;L++)(L>0||s==1&&!Ze)&&Dy(L,de[L]);Ny()}qe=!1,M!==!1&&Ln("setLegend")}i.setLegend=Wh;function Dy(x,M){let L=S[x],D=x==0&&U==2?pi:e[x],B;Ze?B=L.values(i,x,M)??mt:(B=L.value(i,M==null?null:D[M],x,M),B=B==null?mt:{_:B}),ue.values[x]=B}function Tr(x,M,L){Cp=Yt,Rp=sn,[Yt,sn]=_e.move(i,Yt,sn),_e.left=Yt,_e.top=sn,et&&(to&&as(to,Mn(Yt),0,We,fe),no&&as(no,0,Mn(sn),We,fe));let D,B=on>pn;xs=Wt,Bs=null;let Z=I.ori==0?We:fe,re=I.ori==1?We:fe;if(Yt<0||gn==0||B){D=_e.idx=null;for(let pe=0;pe<S.length;pe++){let ye=li[pe];ye!=null&&as(ye,-10,-10,We,fe)}Un&&is(null,oo,!0,x==null&&_n.setSeries),ue.live&&(de.fill(D),qe=!0)}else{let pe,ye,Re;s==1&&(pe=I.ori==0?Yt:sn,ye=ss(pe,T),D=_e.idx=Xi(ye,e[0],on,pn),Re=k(e[0][D],I,Z,0));let Le=-10,Fe=-10,nt=0,Ct=0,Mt=!0,dt="",Ke="";for(let He=s==2?1:0;He<S.length;He++){let Kt=S[He],un=de[He],Nn=un==null?null:s==1?e[He][un]:e[He][1][un],Gt=_e.dataIdx(i,He,D,ye),hn=Gt==null?null:s==1?e[He][Gt]:e[He][1][Gt];if(qe=qe||hn!=Nn||Gt!=un,de[He]=Gt,He>0&&Kt.show){let gi=Gt==null?-10:Gt==D?Re:k(s==1?e[0][Gt]:e[He][0][Gt],I,Z,0),Qn=hn==null?-10:X(hn,s==1?b[Kt.scale]:b[Kt.facets[1].scale],re,0);if(Un&&hn!=null){let Li=I.ori==1?Yt:sn,zi=Sn(ht.dist(i,He,Gt,Qn,Li));if(zi<xs){let rs=ht.bias;if(rs!=0){let _i=ss(Li,Kt.scale),Ni=hn>=0?1:-1,Gi=_i>=0?1:-1;Gi==Ni&&(Gi==1?rs==1?hn>=_i:hn<=_i:rs==1?hn<=_i:hn>=_i)&&(xs=zi,Bs=He)}else xs=zi,Bs=He}}if(qe||On){let Li,zi;I.ori==0?(Li=gi,zi=Qn):(Li=Qn,zi=gi);let rs,_i,Ni,Gi,os,ei,xi=!0,Er=lt.bbox;if(Er!=null){xi=!1;let ti=Er(i,He);Ni=ti.left,Gi=ti.top,rs=ti.width,_i=ti.height}else Ni=Li,Gi=zi,rs=_i=lt.size(i,He);if(ei=lt.fill(i,He),os=lt.stroke(i,He),On)He==Bs&&xs<=ht.prox&&(Le=Ni,Fe=Gi,nt=rs,Ct=_i,Mt=xi,dt=ei,Ke=os);else{let ti=li[He];ti!=null&&(Ds[He]=Ni,_s[He]=Gi,gm(ti,rs,_i,xi),pm(ti,ei,os),as(ti,Fi(Ni),Fi(Gi),We,fe))}}}}if(On){let He=ht.prox,Kt=wr==null?xs<=He:xs>He||Bs!=wr;if(qe||Kt){let un=li[0];un!=null&&(Ds[0]=Le,_s[0]=Fe,gm(un,nt,Ct,Mt),pm(un,dt,Ke),as(un,Fi(Le),Fi(Fe),We,fe))}}}if(Zt.show&&Os)if(x!=null){let[pe,ye]=_n.scales,[Re,Le]=_n.match,[Fe,nt]=x.cursor.sync.scales,Ct=x.cursor.drag;if(Pn=Ct._x,In=Ct._y,Pn||In){let{left:Mt,top:dt,width:Ke,height:He}=x.select,Kt=x.scales[Fe].ori,un=x.posToVal,Nn,Gt,hn,gi,Qn,Li=pe!=null&&Re(pe,Fe),zi=ye!=null&&Le(ye,nt);Li&&Pn?(Kt==0?(Nn=Mt,Gt=Ke):(Nn=dt,Gt=He),hn=b[pe],gi=k(un(Nn,Fe),hn,Z,0),Qn=k(un(Nn+Gt,Fe),hn,Z,0),ua(qi(gi,Qn),Sn(Qn-gi))):ua(0,Z),zi&&In?(Kt==1?(Nn=Mt,Gt=Ke):(Nn=dt,Gt=He),hn=b[ye],gi=X(un(Nn,nt),hn,re,0),Qn=X(un(Nn+Gt,nt),hn,re,0),ha(qi(gi,Qn),Sn(Qn-gi))):ha(0,re)}else $h()}else{let pe=Sn(Cp-Ep),ye=Sn(Rp-Ap);if(I.ori==1){let nt=pe;pe=ye,ye=nt}Pn=kn.x&&pe>=kn.dist,In=kn.y&&ye>=kn.dist;let Re=kn.uni;Re!=null?Pn&&In&&(Pn=pe>=Re,In=ye>=Re,!Pn&&!In&&(ye>pe?In=!0:Pn=!0)):kn.x&&kn.y&&(Pn||In)&&(Pn=In=!0);let Le,Fe;Pn&&(I.ori==0?(Le=io,Fe=Yt):(Le=so,Fe=sn),ua(qi(Le,Fe),Sn(Fe-Le)),In||ha(0,re)),In&&(I.ori==1?(Le=io,Fe=Yt):(Le=so,Fe=sn),ha(qi(Le,Fe),Sn(Fe-Le)),Pn||ua(0,Z)),!Pn&&!In&&(ua(0,0),ha(0,0))}if(kn._x=Pn,kn._y=In,x==null){if(L){if(Gp!=null){let[pe,ye]=_n.scales;_n.values[0]=pe!=null?ss(I.ori==0?Yt:sn,pe):null,_n.values[1]=ye!=null?ss(I.ori==1?Yt:sn,ye):null}fa(nd,i,Yt,sn,We,fe,D)}if(Un){let pe=L&&_n.setSeries,ye=ht.prox;wr==null?xs<=ye&&is(Bs,oo,!0,pe):xs>ye?is(null,oo,!0,pe):Bs!=wr&&is(Bs,oo,!0,pe)}}qe&&(ue.idx=D,Wh()),M!==!1&&Ln("setCursor")}let Vs=null;Object.defineProperty(i,"rect",{get(){return Vs==null&&da(!1),Vs}});function da(x=!1){x?Vs=null:(Vs=p.getBoundingClientRect(),Ln("syncRect",Vs))}function Lp(x,M,L,D,B,Z,re){_e._lock||Os&&x!=null&&x.movementX==0&&x.movementY==0||(Xh(x,M,L,D,B,Z,re,!1,x!=null),x!=null?Tr(null,!0,!0):Tr(M,!0,!1))}function Xh(x,M,L,D,B,Z,re,pe,ye){if(Vs==null&&da(!1),Ne(x),x!=null)L=x.clientX-Vs.left,D=x.clientY-Vs.top;else{if(L<0||D<0){Yt=-10,sn=-10;return}let[Re,Le]=_n.scales,Fe=M.cursor.sync,[nt,Ct]=Fe.values,[Mt,dt]=Fe.scales,[Ke,He]=_n.match,Kt=M.axes[0].side%2==1,un=I.ori==0?We:fe,Nn=I.ori==1?We:fe,Gt=Kt?Z:B,hn=Kt?B:Z,gi=Kt?D:L,Qn=Kt?L:D;if(Mt!=null?L=Ke(Re,Mt)?a(nt,b[Re],un,0):-10:L=un*(gi/Gt),dt!=null?D=He(Le,dt)?a(Ct,b[Le],Nn,0):-10:D=Nn*(Qn/hn),I.ori==1){let Li=L;L=D,D=Li}}ye&&(M==null||M.cursor.event.type==nd)&&((L<=1||L>=We-1)&&(L=Cr(L,We)),(D<=1||D>=fe-1)&&(D=Cr(D,fe))),pe?(Ep=L,Ap=D,[io,so]=_e.move(i,L,D)):(Yt=L,sn=D)}let qh={width:0,height:0,left:0,top:0};function $h(){Cl(qh,!1)}let Np,Dp,Fp,Up;function Op(x,M,L,D,B,Z,re){Os=!0,Pn=In=kn._x=kn._y=!1,Xh(x,M,L,D,B,Z,re,!0,!1),x!=null&&(bt(id,ld,kp,!1),fa(am,i,io,so,We,fe,null));let{left:pe,top:ye,width:Re,height:Le}=Zt;Np=pe,Dp=ye,Fp=Re,Up=Le}function kp(x,M,L,D,B,Z,re){Os=kn._x=kn._y=!1,Xh(x,M,L,D,B,Z,re,!1,!0);let{left:pe,top:ye,width:Re,height:Le}=Zt,Fe=Re>0||Le>0,nt=Np!=pe||Dp!=ye||Fp!=Re||Up!=Le;if(Fe&&nt&&Cl(Zt),kn.setScale&&Fe&&nt){let Ct=pe,Mt=Re,dt=ye,Ke=Le;if(I.ori==1&&(Ct=ye,Mt=Le,dt=pe,Ke=Re),Pn&&ks(T,ss(Ct,T),ss(Ct+Mt,T)),In)for(let He in b){let Kt=b[He];He!=T&&Kt.from==null&&Kt.min!=Wt&&ks(He,ss(dt+Ke,He),ss(dt,He))}$h()}else _e.lock&&(_e._lock=!_e._lock,Tr(M,!0,x!=null));x!=null&&(Ut(id,ld),fa(id,i,Yt,sn,We,fe,null))}function Fy(x,M,L,D,B,Z,re){if(_e._lock)return;Ne(x);let pe=Os;if(Os){let ye=!0,Re=!0,Le=10,Fe,nt;I.ori==0?(Fe=Pn,nt=In):(Fe=In,nt=Pn),Fe&&nt&&(ye=Yt<=Le||Yt>=We-Le,Re=sn<=Le||sn>=fe-Le),Fe&&ye&&(Yt=Yt<io?0:We),nt&&Re&&(sn=sn<so?0:fe),Tr(null,!0,!0),Os=!1}Yt=-10,sn=-10,de.fill(null),Tr(null,!0,!0),pe&&(Os=pe)}function Bp(x,M,L,D,B,Z,re){_e._lock||(Ne(x),la(),$h(),x!=null&&fa(um,i,Yt,sn,We,fe,null))}function Vp(){C.forEach(Wb),V(i.width,i.height,!0)}Ir(Vl,po,Vp);let ao={};ao.mousedown=Op,ao.mousemove=Lp,ao.mouseup=kp,ao.dblclick=Bp,ao.setSeries=(x,M,L,D)=>{let B=_n.match[2];L=B(i,M,L),L!=-1&&is(L,D,!0,!1)},et&&(bt(am,p,Op),bt(nd,p,Lp),bt(lm,p,x=>{Ne(x),da(!1)}),bt(cm,p,Fy),bt(um,p,Bp),gd.add(i),i.syncRect=da);let Rl=i.hooks=n.hooks||{};function Ln(x,M,L){Qr?ca.push([x,M,L]):x in Rl&&Rl[x].forEach(D=>{D.call(null,i,M,L)})}(n.plugins||[]).forEach(x=>{for(let M in x.hooks)Rl[M]=(Rl[M]||[]).concat(x.hooks[M])});let zp=(x,M,L)=>L,_n=xn({key:null,setSeries:!1,filters:{pub:bm,sub:bm},scales:[T,S[1]?S[1].scale:null],match:[Mm,Mm,zp],values:[null,null]},_e.sync);_n.match.length==2&&_n.match.push(zp),_e.sync=_n;let Gp=_n.key,Yh=xg(Gp);function fa(x,M,L,D,B,Z,re){_n.filters.pub(x,M,L,D,B,Z,re)&&Yh.pub(x,M,L,D,B,Z,re)}Yh.sub(i);function Uy(x,M,L,D,B,Z,re){_n.filters.sub(x,M,L,D,B,Z,re)&&ao[x](null,M,L,D,B,Z,re)}i.pub=Uy;function Oy(){Yh.unsub(i),gd.delete(i),$t.clear(),hd(Vl,po,Vp),c.remove(),ae?.remove(),Ln("destroy")}i.destroy=Oy;function Zh(){Ln("init",n,e),Al(e||n.data,!1),O[T]?zh(T,O[T]):la(),Xe=Zt.show&&(Zt.width>0||Zt.height>0),Oe=qe=!0,V(n.width,n.height)}return S.forEach(wl),C.forEach(oa),t?t instanceof HTMLElement?(t.appendChild(c),Zh()):t(i,Zh):Zh(),i}wn.assign=xn;wn.fmtNum=Sd;wn.rangeNum=zl;wn.rangeLog=Wl;wn.rangeAsinh=bd;wn.orient=Nr;wn.pxRatio=Rt;wn.join=Fv;wn.fmtDate=Td,wn.tzDate=qv;wn.sync=xg;{wn.addGap=Cb,wn.clipGaps=$l;let n=wn.paths={points:wg};n.linear=Eg,n.stepped=Ib,n.bars=Lb,n.spline=Db}function Pg(n,e,t,i,s){return r=>{let{ctx:o,bbox:a}=r,l=devicePixelRatio,c=h=>r.valToPos(h*i,"x",!0),u=h=>h>=a.left-1&&h<=a.left+a.width+1;if(o.save(),n.window){let h=Math.max(a.left,c(n.window.from)),d=Math.min(a.left+a.width,c(n.window.to));o.fillStyle=t.window,d>h&&o.fillRect(h,a.top,d-h,a.height)}o.lineWidth=2*l,o.strokeStyle=t.limit;for(let{value:h}of e){let d=r.valToPos(h*s,"y",!0);d<a.top||d>a.top+a.height||(o.beginPath(),o.moveTo(a.left,d),o.lineTo(a.left+a.width,d),o.stroke())}o.lineWidth=l,o.strokeStyle=t.event,o.fillStyle=t.event,o.setLineDash([2*l,3*l]),o.font=`600 ${11*l}px system-ui, sans-serif`,o.textAlign="center",o.textBaseline="bottom",(n.events??[]).forEach((h,d)=>{let f=c(h.x);u(f)&&(o.beginPath(),o.moveTo(f,a.top),o.lineTo(f,a.top+a.height),o.stroke(),o.fillText(String(d+1),f,a.top-2*l))}),o.restore()}}var Ig="12px system-ui, sans-serif";function Xs(n,e){let t=0;for(let i of n.curves){let s=dn(i.y);s&&(t=Math.max(t,Math.abs(s[0]),Math.abs(s[1])))}return{xScale:kt(Dl[n.along],e,1),yScale:kt(n.yUnit,e,t)}}function wa(n,e){return e.symbol?`${n}, ${e.symbol}`:n}function Xb(n,e,t){let i=Hi(t.theme).curve[n.role],s={label:n.label,show:!t.hidden.has(e),stroke:i,width:n.points?0:co[n.role],dash:lo[n.role],points:n.points?{show:!0,size:6,space:0,fill:Hi(t.theme).paper,stroke:i,width:1.5}:{show:!1}};return n.points&&(s.paths=()=>null),s}function qb(n,e,t,i){let s=Hi(e.theme),r={stroke:s.muted,font:Ig,labelFont:Ig,labelSize:20,grid:{stroke:s.grid,width:1},ticks:{stroke:s.grid,width:1,size:4},values:(a,l)=>ga(l)},o=Math.max(3,Math.floor(e.width/110));return[{...r,label:wa(n.xLabel,t),size:30,splits:(a,l,c,u)=>uo(c,u,o)},{...r,label:wa(n.yLabel,i),size:(a,l)=>16+7*Math.max(2,...(l??[]).map(c=>c.length)),splits:(a,l,c,u)=>uo(c,u,Math.max(3,e.height/55))}]}function Lg(n,e,t){let i=zs(e.curves),{xScale:s,yScale:r}=Xs(e,t.units),o=dn(i.x)??[0,1];o[0]===o[1]&&(o[1]=o[0]+1);let a=s.factor,l=r.factor,c=g=>g.map(m=>m==null?m:m*l),u=[i.x.map(g=>g*a),...i.y.map(c)],h=t.zoom??o,d=Hi(t.theme),f=[{},...e.curves.map((g,m)=>Xb(g,m,t))],p=(g,m,S)=>{let[C,b]=Nl(e,(m??0)/l,(S??l)/l);return[C*l,b*l]},_=new wn({width:t.width,height:t.height,padding:[18,14,0,0],pxAlign:0,legend:{show:!1},cursor:{y:!1,drag:{x:!0,y:!1,dist:5},points:{size:7,fill:d.paper,width:2}},scales:{x:{time:!1,range:(g,m,S)=>m===null||S===null?[0,1]:[m,S]},y:{range:p}},axes:qb(e,t,s,r),series:f,bands:e.band?[{series:[e.band.high+1,e.band.low+1],fill:d.band}]:[],hooks:{setCursor:[g=>{let{left:m,event:S}=g.cursor;S&&t.onCursor(m===void 0||m<0?null:g.posToVal(m,"x")/a)}],setScale:[(g,m)=>{let{min:S,max:C}=g.scales.x;m==="x"&&typeof S=="number"&&typeof C=="number"&&t.onZoom([S/a,C/a])}],drawAxes:[Pg(e,Ar(e),d,a,l)]}},u,n);return _.setScale("x",{min:h[0]*a,max:h[1]*a}),{chart:_,aligned:i,xScale:s,yScale:r,reach:o}}var Mo=680,Ms=250,$s=58,Ea=12,qs=16,Dr=40,ls=Hi("light");function $b(n,e,t,i,s,r){let o="",a=!1,l=NaN,c=NaN;return n.x.forEach((u,h)=>{let d=n.y[e]?.[h];if(d===void 0||u<t||u>i)return;if(d===null){a=!1;return}let[f,p]=[s(u),r(d)];a&&Math.abs(f-l)<.25&&Math.abs(p-c)<.25||(o+=`${a?"L":"M"}${f.toFixed(1)} ${p.toFixed(1)}`,[a,l,c]=[!0,f,p])}),o}function Yb(n,e,t,i,s){let o=n.x.map((c,u)=>({x:c,low:n.y[e]?.[u],high:n.y[t]?.[u]})).filter(c=>typeof c.low=="number"&&typeof c.high=="number");if(o.length<2)return"";let a=o.map(c=>`${i(c.x).toFixed(1)} ${s(c.high).toFixed(1)}`),l=o.reverse().map(c=>`${i(c.x).toFixed(1)} ${s(c.low).toFixed(1)}`);return`M${a.join("L")}L${l.join("L")}Z`}function Ta(n,e,t,i,s=ls.muted){return Qe("text",{x:n,y:e,"text-anchor":i,fill:s,"font-size":11},t)}function Zb(n,e,t,i,s,r){let{xScale:o,yScale:a}=Xs(n,e),l=[],c=uo(t[0]*o.factor,t[1]*o.factor,8),u=uo(i[0]*a.factor,i[1]*a.factor,5);ga(c).forEach((d,f)=>{let p=s(c[f]/o.factor);l.push(Qe("path",{d:`M${p} ${qs}V${Ms-Dr}`,stroke:ls.grid})),l.push(Ta(p,Ms-Dr+14,d,"middle"))}),ga(u).forEach((d,f)=>{let p=r(u[f]/a.factor);l.push(Qe("path",{d:`M${$s} ${p}H${Mo-Ea}`,stroke:ls.grid})),l.push(Ta($s-6,p+4,d,"end"))}),l.push(Ta(($s+Mo-Ea)/2,Ms-6,wa(n.xLabel,o),"middle"));let h=Ta(0,0,wa(n.yLabel,a),"middle");return h.setAttribute("transform",`translate(12 ${(qs+Ms-Dr)/2}) rotate(-90)`),l.push(h),l}function Ng(n,e,t,i){let s=zs(n.curves),r=t??dn(s.x)??[0,1],o=Nl(n,...Qp(s,r[0],r[1],i)),a=p=>$s+(p-r[0])/(r[1]-r[0]||1)*(Mo-$s-Ea),l=p=>Ms-Dr-(p-o[0])/(o[1]-o[0]||1)*(Ms-qs-Dr),c=`clip-${n.id}`,u={x:$s,y:qs,width:Mo-$s-Ea,height:Ms-qs-Dr},h=Zb(n,e,r,o,a,l),d=Qe("g",{"clip-path":`url(#${c})`,fill:"none"});if(n.window){let p=a(n.window.from);d.append(Qe("rect",{x:p,y:qs,width:Math.max(0,a(n.window.to)-p),height:u.height,fill:ls.window}))}n.band&&d.append(Qe("path",{d:Yb(s,n.band.low,n.band.high,a,l),fill:ls.band})),n.curves.forEach((p,_)=>{if(i.has(_))return;let g=ls.curve[p.role];if(p.points){p.x.forEach((C,b)=>{let R=p.y[b];C===null||R===null||R===void 0||d.append(Qe("circle",{cx:a(C),cy:l(R),r:2.4,fill:ls.paper,stroke:g}))});return}let m=lo[p.role].join(" ")||null,S=$b(s,_,r[0],r[1],a,l);d.append(Qe("path",{d:S,stroke:g,"stroke-width":co[p.role]*.75,"stroke-dasharray":m}))});for(let{value:p}of Ar(n))d.append(Qe("path",{d:`M${$s} ${l(p)}H${Mo-Ea}`,stroke:ls.limit,"stroke-width":1.5}));(n.events??[]).forEach((p,_)=>{p.x<r[0]||p.x>r[1]||(d.append(Qe("path",{d:`M${a(p.x)} ${qs}V${Ms-Dr}`,stroke:ls.event,"stroke-dasharray":"2 3"})),h.push(Ta(a(p.x),qs-4,String(_+1),"middle",ls.event)))});let f={viewBox:`0 0 ${Mo} ${Ms}`,class:"paper-figure",role:"img","aria-label":n.title};return Qe("svg",f,Qe("clipPath",{id:c},Qe("rect",u)),...h,d)}function Dg(n,e){let{xScale:t,yScale:i}=Xs(n,e),s=zs(n.curves),r=[{label:n.xLabel,unit:t.symbol},...n.curves.map(a=>({label:a.label,unit:i.symbol}))],o=s.x.map((a,l)=>[a*t.factor,...s.y.map(c=>{let u=c[l];return typeof u=="number"?u*i.factor:u})]);return{name:`hawser-${n.id}`,columns:r,rows:o}}var Kb=400;function Jb(n){if(n==null)return"";if(typeof n=="number")return Number.isFinite(n)?String(Number(n.toPrecision(12))):"";let e=/^[=+\-@]/.test(n)?`'${n}`:n;return/[",\r\n]/.test(e)?`"${e.replaceAll('"','""')}"`:e}var Ug=n=>n.unit?`${n.label}, ${n.unit}`:n.label;function Fg(n){return[n.columns.map(Ug),...n.rows].map(t=>t.map(Jb).join(",")).join(`\r
`)+`\r
`}async function jb(n){try{return await navigator.clipboard.writeText(n),!0}catch{let e=A("textarea",{class:"offscreen",readonly:!0});e.value=n,document.body.append(e),e.select();let t=document.execCommand("copy");return e.remove(),t}}function Qb(n,e){let t=URL.createObjectURL(new Blob([e],{type:"text/csv"}));A("a",{href:t,download:`${n}.csv`}).click(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}function Ld(n,e,t=6){let i=n.rows.slice(0,Kb),r=n.rows.length>i.length?` (the first ${i.length} of ${n.rows.length} rows; the CSV has all)`:"",o=i.map(l=>A("tr",{},...l.map(c=>typeof c=="number"?A("td",{class:"number"},fn(c,t)):A("td",{},c===null?ci:ft(c??""))))),a=A("tr",{},...n.columns.map(l=>A("th",{scope:"col"},Ug(l))));return A("div",{class:"scroll",tabindex:0,role:"region","aria-label":e},A("table",{class:"data"},A("caption",{},e+r),A("thead",{},a),A("tbody",{},...o)))}function $i(n){let e=A("span",{class:"said",role:"status"}),t=ni("Copy CSV",()=>{jb(Fg(n())).then(s=>{e.textContent=s?"copied":"the browser does not allow copying",setTimeout(()=>e.textContent="",4e3)})}),i=ni("Save CSV",()=>{let s=n();Qb(s.name,Fg(s))});return A("div",{class:"tools"},t,i,e)}function Jl(n,e,t,i){let s=A("div",{class:"behind"}),r=l=>{o.setAttribute("aria-expanded",String(l)),o.textContent=l?"Hide table":"Table",s.replaceChildren(...l?[Ld(n(),e)]:[])},o=ni("Table",()=>{let l=o.getAttribute("aria-expanded")!=="true";r(l),i(l)});r(t);let a=$i(n);return a.prepend(o),[a,s]}var eM="Arrow keys move the cursor, plus and minus zoom, 0 shows all.";function tM(n,e){let{yScale:t}=Xs(n,e.get("units")),i=n.curves.filter(s=>!s.quiet).map(s=>{let r=dn(s.y);if(!r)return`${s.label}: nothing known`;let[o,a]=r.map(l=>(l*t.factor).toPrecision(4));return`${s.label}: from ${o} to ${a} ${t.symbol}`});return`${n.title}. ${i.join("; ")}. ${eM}`}var So=class{constructor(e,t,i){this.spec=e;this.store=t;this.memory=i;this.frame=A("div",{class:"frame",tabindex:0,role:"group","aria-roledescription":"figure","aria-label":tM(e,t)},this.root),this.frame.addEventListener("keydown",c=>this.key(c));let r=Jl(()=>Dg(e,t.get("units")),e.title,i.open,c=>i.open=c),o=A("figcaption",{},A("p",{class:"caption"},e.caption),...r);this.element=A("figure",{id:`figure-${e.id}`,class:"figure"},A("h3",{},e.title),this.legendRoot,this.frame,this.paper,this.said,o);for(let c of["place","time"])this.ends.push(t.subscribe(c,(u,h)=>h!==this&&this.follow()));let a=new ResizeObserver(()=>this.resize());a.observe(this.frame);let l=()=>{this.wanted=!0,this.resize()};this.ends.push(()=>a.disconnect(),Pl(this.element,l)),this.drawLegend(t.get("theme"))}spec;store;memory;element;root=A("div",{class:"plot"});frame;paper=A("div",{class:"on-paper"});said=A("p",{class:"offscreen",role:"status"});legendRoot=A("div");ends=[];plot=null;wanted=!1;legend=null;dispose(){for(let e of this.ends)e();this.plot?.chart.destroy(),this.plot=null}print(e){let{spec:t,store:i,memory:s}=this;this.drawLegend(e?"light":i.get("theme")),this.paper.replaceChildren(...e?[Ng(t,i.get("units"),s.zoom,s.hidden)]:[])}width(){return Math.max(240,Math.floor(this.frame.clientWidth)-2)}resize(){let e=this.spec.height??(this.width()<560?220:280);this.frame.clientWidth!==0&&(this.root.style.minHeight=`${e}px`,this.wanted&&(this.plot&&this.plot.chart.width===this.width()||(this.plot?this.plot.chart.setSize({width:this.width(),height:e}):this.draw(e),this.follow())))}draw(e){let{spec:t,store:i,memory:s}=this;this.plot?.chart.destroy(),this.plot=Lg(this.root,t,{width:this.width(),height:e,theme:i.get("theme"),units:i.get("units"),hidden:s.hidden,zoom:s.zoom,onCursor:r=>this.point(r),onZoom:r=>this.remember(r)}),this.drawLegend(i.get("theme"))}drawLegend(e){let{spec:t,store:i,memory:s}=this,r=i.get("units"),o=this.plot?.aligned??zs(t.curves);this.legend=tm(t,o,Xs(t,r).yScale,{theme:e,units:r,hidden:s.hidden,onToggle:a=>this.toggle(a)}),this.legendRoot.replaceChildren(this.legend.element)}toggle(e){let{hidden:t}=this.memory;t.delete(e)||t.add(e),this.plot&&this.draw(this.plot.chart.height);let i=this.legendRoot.querySelectorAll("button"),s=this.spec.curves.map((r,o)=>o).filter(r=>!this.spec.curves[r]?.quiet);i[s.indexOf(e)]?.focus(),this.follow()}remember(e){let t=this.plot?.reach??e,i=(t[1]-t[0])*1e-6,s=e[0]<=t[0]+i&&e[1]>=t[1]-i;this.memory.zoom=s?null:e,this.element.classList.toggle("zoomed",!s)}point(e){this.legend?.update(e??Fl(this.spec,this.store)),ed(this.spec,this.store,e,this)}follow(){let e=Fl(this.spec,this.store);this.plot&&nm(this.plot,e),this.legend?.update(e)}key(e){let{plot:t,spec:i,store:s}=this;if(!t||e.target!==this.frame)return;let{factor:r}=t.xScale;im(e,{reach:()=>t.reach,view:()=>this.memory.zoom??t.reach,cursor:()=>Fl(i,s),move:o=>{ed(i,s,o,null),this.said.textContent=this.legend?.sentence()??""},zoom:([o,a])=>{t.chart.setScale("x",{min:o*r,max:a*r}),this.follow()}})}};var wo=class{constructor(e){this.state=e}state;listeners=new Map;get(e){return this.state[e]}set(e,t,i=null){if(Object.is(this.state[e],t))return;this.state[e]=t;let s=this.listeners.get(e);for(let r of[...s??[]])r(t,i)}subscribe(e,t){let i=this.listeners.get(e)??new Set;return i.add(t),this.listeners.set(e,i),()=>{i.delete(t)}}};var Og=()=>new Promise(n=>{let{port1:e,port2:t}=new MessageChannel;e.onmessage=()=>{e.close(),n()},t.postMessage(0)});async function nM(n){let e=n.endsWith("==")?2:n.endsWith("=")?1:0,t=new Uint8Array(n.length/4*3-e),i=0;for(let s=0;s<n.length;s+=1048576){let r=atob(n.slice(s,s+1048576));for(let o=0;o<r.length;o++)t[i++]=r.charCodeAt(o);s+1048576<n.length&&await Og()}return t}async function iM(n){let e=new Blob([n]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(e).arrayBuffer())}async function Ys(n,e,t,i){let s=e*t*i,r=await iM(await nM(n));if(r.length!==4*s)throw new Error(`a field has ${r.length} bytes, not ${4*s}`);let o=new Int32Array(s),a=t*i,l=performance.now();for(let c=0;c<e;c++)sM(r,o,s,c*a,a,i),performance.now()-l>6&&(await Og(),l=performance.now());return o}function sM(n,e,t,i,s,r){let o=i===0;for(let a=0;a<s;a++){let l=i+a,c=n[l]|n[l+t]<<8|n[l+2*t]<<16|n[l+3*t]<<24,u=c>>>1^-(c&1);a>=r&&(u+=e[l-r]-(o?0:e[l-s-r])),o||(u+=e[l-s]),e[l]=u}}function Nd(n,e){let t=0,i=n.length-1;for(;t<i;){let s=t+i+1>>1;n[s]<=e?t=s:i=s-1}return t}var Fr=class{constructor(e,t){this.items=t;this.time=Float64Array.from(e)}items;time;fields=new Map;get count(){return this.time.length}get from(){return this.time[0]??0}get to(){return this.time[this.count-1]??0}between(e){let t=Nd(this.time,e),i=Math.min(t+1,this.count-1),s=this.time[i]-this.time[t];return{frame:t,next:i,part:s>0?Math.min(1,Math.max(0,(e-this.time[t])/s)):0}}sample(e,t,i,s=[]){let r=this.fields.get(e);if(!r)return!1;let{components:o,step:a}=r.meta,l=this.items*o,c=t.frame*l,u=t.next*l,h=r.q;for(let d=0;d<o;d++){let f=s[d]??0;for(let p=d;p<l;p+=o){let _=h[c+p];i[p]=a*(_+t.part*(h[u+p]-_))-f}}return!0}timeOfLargest(e){let t=this.fields.get(e)?.q;if(!t||t.length===0)return null;let i=t.reduce((s,r,o)=>r>t[s]?o:s,0);return this.time[Math.floor(i/this.items)]??null}history(e,t){let i=this.fields.get(e);if(!i)return null;let{components:s,step:r}=i.meta;return Float64Array.from(this.time,(o,a)=>{let l=(a*this.items+t(a))*s,c=0;if(s===1)return r*i.q[l];for(let u=0;u<s;u++)c+=i.q[l+u]**2;return r*Math.sqrt(c)})}};async function Dd(n,e){let t=new Fr(n.time_s,n.segments),i=Object.keys(n.packed).sort((s,r)=>+(r==="position")-+(s==="position"));for(let s of i){let r=n.fields[s];if(!r)continue;let o=await Ys(n.packed[s],n.frames,n.segments,r.components);t.fields.set(s,{meta:r,q:o}),e(t,s)}return t}var vt=(n,e)=>[n[0]-e[0],n[1]-e[1],n[2]-e[2]],Bt=(n,e,t=1)=>[n[0]+t*e[0],n[1]+t*e[1],n[2]+t*e[2]],Gn=(n,e)=>n[0]*e[0]+n[1]*e[1]+n[2]*e[2],Mi=(n,e)=>[n[1]*e[2]-n[2]*e[1],n[2]*e[0]-n[0]*e[2],n[0]*e[1]-n[1]*e[0]],si=n=>Math.hypot(n[0],n[1],n[2]);function Nt(n,e=[1,0,0]){let t=si(n);return t>1e-12?[n[0]/t,n[1]/t,n[2]/t]:e}var jl=class{constructor(e,t){this.s=e;this.points=t;this.along=t.slice(1).map((i,s)=>Nt(vt(i,t[s])))}s;points;along;get from(){return this.s[0]??0}get to(){return this.s[this.points.length-1]??0}piece(e){return Math.max(0,Math.min(this.points.length-2,Nd(this.s,e)))}at(e){let t=this.piece(e),i=this.s[t+1]-this.s[t],s=(e-this.s[t])/i;if(s>=0&&s<=1)return Bt(this.points[t],vt(this.points[t+1],this.points[t]),s);let r=s<0?t:t+1;return Bt(this.points[r],this.along[t],e-this.s[r])}tangent(e){return this.along[this.piece(e)]??[1,0,0]}nearest([e,t,i]){let{s,points:r,along:o}=this,a=1/0,l=this.from;for(let c=0;c+1<r.length;c++){let u=r[c],h=o[c],d=e-u[0],f=t-u[1],p=i-u[2],_=s[c+1]-s[c],g=Math.min(_,Math.max(0,d*h[0]+f*h[1]+p*h[2])),m=(d-g*h[0])**2+(f-g*h[1])**2+(p-g*h[2])**2;m<a&&(a=m,l=s[c]+g)}return{s:l,distance:Math.sqrt(a)}}};var To=[0,0,1],Fd=n=>n*Math.PI/180;function Ql(n){let e=Math.max(1,n.length),t=n.reduce((c,u)=>Bt(c,u,1/e),[0,0,0]),i=0,s=0,r=0;for(let c of n){let[u,h]=vt(c,t);i+=u*u,s+=u*h,r+=h*h}let o=.5*Math.atan2(2*s,i-r),a=[Math.cos(o),Math.sin(o),0],l=n.length>1?vt(n[e-1],n[0]):a;return Gn(l,a)<0?[-a[0],-a[1],0]:a}function ec(n,e,t,i,s=.12){let r=Nt(Mi(To,e),[0,1,0]),o=Mi(e,r),a=Math.tan(Fd(t)/2)*(1-s),l=rM(n,[r,o,e]),c=0;for(let u=0;u<4;u++){c=1;for(let f of n){let p=vt(f,l),_=Math.max(Math.abs(Gn(p,r))/(a*i),Math.abs(Gn(p,o))/a);c=Math.max(c,Gn(p,e)+_)}let h=n.map(f=>{let p=vt(f,l),_=Math.max(1e-6,c-Gn(p,e));return[Gn(p,r)/_,Gn(p,o)/_]}),d=f=>{let p=h.map(_=>_[f]);return .5*(p.reduce((_,g)=>Math.min(_,g))+p.reduce((_,g)=>Math.max(_,g)))};l=Bt(Bt(l,r,d(0)*c),o,d(1)*c)}return{position:Bt(l,e,c),target:l,fov:t}}function rM(n,e){return e.reduce((t,i)=>{let s=n.map(a=>Gn(a,i)),r=s.reduce((a,l)=>Math.min(a,l),1/0),o=s.reduce((a,l)=>Math.max(a,l),-1/0);return Bt(t,i,.5*(r+o))},[0,0,0])}function tc(n,e){let t=Mi(n,To);return Nt(Bt([0,0,Math.sin(Fd(e))],t,Math.cos(Fd(e))))}var kg=(n,e)=>ec(n,tc(Ql(n),32),35,e),Bg=(n,e)=>ec(n,tc(Ql(n),89.9),20,e),Vg=(n,e)=>ec(n,tc(Ql(n),2),20,e);function zg(n,e,t){let i=n.tangent(e),s=Nt(Mi(i,To),[0,1,0]),r=Nt([i[0],i[1],0],i),o=n.at(e);return{position:Bt(Bt(Bt(o,r,-t),s,.35*t),To,.4*t),target:o,fov:50}}function Gg(n,e,t){let i=e.to-e.from,s=Math.max(.5,.15*i),r=Math.max(n.from,e.from-s),o=Math.min(n.to,e.to+s),a=Array.from({length:33},(d,f)=>n.at(r+(o-r)*f/32)),l=vt(n.tangent(e.to+1e-6),n.tangent(Math.max(n.from,e.from-1e-6))),c=Math.abs(l[2])>Math.hypot(l[0],l[1]),u=si(vt(a[32],a[0]))*.03,h=a.flatMap(d=>[Bt(d,To,u),Bt(d,To,-u)]);return ec(h,tc(Ql(a),c?12:48),35,t)}function Hg(n,e,t){let i=t*t*(3-2*t);return{position:Bt(n.position,vt(e.position,n.position),i),target:Bt(n.target,vt(e.target,n.target),i),fov:n.fov+(e.fov-n.fov)*i}}function Eo(n,e,t){let i=Nt(vt(n.position,n.target));return{position:Bt(e,i,t),target:e,fov:n.fov}}var oM=60,Ud=n=>Math.max(2.5,40*n.diameter),nc=class{constructor(e,t,i){this.world=e;this.now=t;this.time=i}world;now;time;followed=null;atBend=-1;onChange=()=>{};get model(){return this.world.model}changed(){this.onChange(this.atBend<0?null:this.atBend,this.followed!==null)}preset(e,t,i=!1){let{extent:s}=this.model,{stage:r}=this.world,o=[()=>kg(s,r.aspect),()=>this.behind(t),()=>Bg(s,r.aspect),()=>Vg(s,r.aspect)];e!==1&&(this.followed=null),this.atBend=-1,r.go(o[e](),i),this.changed()}behind(e){let{model:t}=this,i=this.now();if(!t.path)return Eo(this.world.stage.pose,i?.centre(t.head)??[0,0,0],Ud(t));let s=i?.headPlace(this.time())??t.path.from;return zg(t.path,e??Math.min(t.path.to,s),Ud(t))}bend(e){let{bends:t,path:i}=this.model,s=t[e];!i||!s||(this.followed=null,this.atBend=e,this.world.stage.go(Gg(i,s,this.world.stage.aspect)),this.changed())}nextBend(e){let t=this.model.bends.length;t>0&&this.bend((this.atBend+e+(this.atBend<0&&e<0?1:0)+t)%t)}follow(e=!this.followed){let t=this.now(),{stage:i}=this.world;this.followed=e&&t?t.centre(this.model.head):null,this.followed&&i.go(Eo(i.pose,this.followed,Math.min(i.distance,oM))),this.changed()}goWithHead(e){if(!this.followed)return;let t=e.centre(this.model.head);this.world.stage.shift(vt(t,this.followed)),this.followed=t}lookAt(e){let{stage:t}=this.world;t.go(Eo(t.goal,e,Ud(this.model)*2))}};var Od=[{field:"tension",title:"Tension",unit:"N"},{field:"sidewall",title:"Sidewall pressure",unit:"N/m"},{field:"curvature",title:"Curvature",unit:"1/m"},{field:"speed",title:"Speed",unit:"m/s"},{field:"contact",title:"Contact force per length",unit:"N/m"}];function Ui(n,e){let{symbol:t,factor:i}=kt("m",e,n);return`${(n*i).toFixed(1).replace("-","\u2212")}\xA0${t}`}function Aa(n,e){if(e<600)return`${n.toFixed(1)}\xA0s`;let t=s=>String(Math.floor(s)).padStart(2,"0"),i=t(n%60);return e<3600?`${Math.floor(n/60)}:${i}\xA0min`:`${Math.floor(n/3600)}:${t(n/60%60)}:${i}\xA0h`}var Wg=.001,aM=1.5*Math.PI/180,lM=.5,cM=.4;function Xg(n){return n.map((e,t)=>{let[i,s]=[n[t-1],n[t+1]];return i&&s?Mi(Nt(vt(e,i)),Nt(vt(s,e))):[0,0,0]})}function qg(n,e,t=[]){let i=[],s=null,r=null,o=()=>{s&&s.angle>=aM&&i.push({...s,number:i.length+1}),s=r=null};for(let a=0;a<n.length;a++){let l=Math.abs(e[a]??0);if(!(l>=Wg&&a+1<n.length)){o();continue}let u=t[a+1];u&&si(u)>cM*l*(n[a+1]-n[a])&&(r&&Gn(Nt(u),r)<lM&&o(),r=Nt(u));let h=Math.abs(e[a+1]??0),d=h>=Wg?.5*(l+h):l;s??={number:0,from:n[a],to:n[a],radius:1/0,angle:0},s.to=n[a+1],s.angle+=d*(s.to-n[a]),s.radius=Math.min(s.radius,1/l)}return i}function ic(n,e){let t=(n.angle*180/Math.PI).toFixed(0);return`Bend ${n.number}: ${t}\xB0, R ${Ui(n.radius,e)}`}var rc=[{name:"Overview",key:"1",title:"The whole route"},{name:"Along",key:"2",title:"Behind the head, along the cable"},{name:"Plan",key:"3",title:"From above"},{name:"Profile",key:"4",title:"From the side"}],Ca=5,Yg=5,Zg=100,Kg=100,sc=class{constructor(e,t,i){this.bends=e;let s=rc.map(({name:r,key:o,title:a},l)=>ni(r,()=>i.preset(l),{title:`${a} (${o})`,"aria-keyshortcuts":o}));this.bendList=A("select",{"aria-label":"Go to a bend",hidden:e.length===0}),this.bendList.addEventListener("change",()=>{this.bendList.value&&i.bend(Number(this.bendList.value))}),this.colours=A("select",{},...t.map(({field:r,title:o})=>A("option",{value:r},o))),this.colours.addEventListener("change",()=>i.colour(this.colours.value)),this.slider.setAttribute("aria-label","Diameter drawn, times the true one"),this.slider.addEventListener("input",()=>{let r=this.slider.valueAsNumber;this.slider.setAttribute("aria-valuetext",r===0?"as suits the view":`times ${$g(r).toFixed(1)}`),i.factor(r===0?null:$g(r))}),this.root=A("div",{class:"view-tools"},A("div",{class:"view-presets",role:"group","aria-label":"Camera"},...s,this.bendList),A("label",{class:"view-field"},"Colour",this.colours),A("label",{class:"view-field",title:"Left end: as suits the view"},"Diameter: auto",this.slider,`\xD7${Zg}`)),this.units("si")}bends;root;bendList;colours;slider=A("input",{type:"range",min:0,max:Kg,step:1,value:0,class:"view-thick"});units(e){let t=this.bends.map((i,s)=>A("option",{value:s},ic(i,e)));this.bendList.replaceChildren(A("option",{value:""},"Bend\u2026"),...t)}coloured(e){this.colours.value=e}atBend(e){this.bendList.value=e===null?"":String(e)}},$g=n=>Zg**((n-1)/(Kg-1));var Jg=[["Space","play, pause"],["\u2190 \u2192","frame by frame (Shift: ten)"],["Home End","first, last"],[", .","slower, faster"],["+ \u2212","zoom"],["W A S D","turn"],[`1\u2013${rc.length}`,"overview, along, plan, profile"],[`${Ca}\u20139`,"bends"],["B","next bend"],["E","next event"],["F","follow the head"],["C","next colour"],["Z","zoom to the place"],["Esc","clear the choice"]];function uM(n,e,t){let i=e?10:1,s=e?-1:1,r=/^[1-9]$/.test(n)?Number(n):0;return r>0&&r<=rc.length?()=>t.preset(r-1):r>=Ca&&r<Ca+Yg?()=>t.bend(r-Ca):{" ":()=>t.toggle(),arrowleft:()=>t.step(-i),arrowright:()=>t.step(i),home:()=>t.end(!1),end:()=>t.end(!0),",":()=>t.faster(-1),".":()=>t.faster(1),"+":()=>t.zoom(1/1.3),"=":()=>t.zoom(1/1.3),"-":()=>t.zoom(1.3),w:()=>t.orbit(0,5),s:()=>t.orbit(0,-5),a:()=>t.orbit(-5,0),d:()=>t.orbit(5,0),b:()=>t.nextBend(s),e:()=>t.event(s),f:()=>t.follow(),c:()=>t.nextColour(),z:()=>t.toPlace(),escape:()=>t.leave()}[n.toLowerCase()]??null}function hM(n,e){return n instanceof HTMLSelectElement?e!=="Escape":n instanceof HTMLButtonElement?e===" "||e==="Enter":n instanceof HTMLInputElement?n.type==="checkbox"?e===" ":!n.classList.contains("view-time")&&/^(Arrow|Home|End)/.test(e):!1}function jg(n,e){let t=i=>{if(i.ctrlKey||i.metaKey||i.altKey||hM(i.target,i.key))return;let s=uM(i.key,i.shiftKey,e);s&&(i.preventDefault(),s())};return n.addEventListener("keydown",t),()=>n.removeEventListener("keydown",t)}var Qg="force";async function e0(n){let e=n.roller_force,t=n.geometry?.rollers.length??0,i=n.states?.time_s??[];if(!e||t===0)return null;let s=new Fr(i,t);return s.fields.set(Qg,{meta:e,q:await Ys(e.packed,i.length,t,e.components)}),s}function dM(n,e){let t=n.series?.[`load_${e}_N`],i=n.series?.time_s;return!Array.isArray(t)||!Array.isArray(i)?null:{time:i.map(Number),values:t.map(s=>typeof s=="number"?s:NaN)}}var t0=(n,e)=>Float64Array.from(n,t=>t*e);function n0(n,e,t,i){let s=n.run.geometry?.rollers[e];if(!s)return null;let r=dM(n.run,s.name),o=r?.values??t?.history(Qg,()=>e)??[],a=r?.time??t?.time??[],l=n.run.rollers,c=l?.name?.indexOf(s.name)??-1,u=m=>{let S=c>=0?l?.[m]?.[c]:null;return typeof S=="number"?S:null},h=u("peak_N"),d=[s.s_m===null?s.kind:`${s.kind} at ${Ui(s.s_m,i)}`];for(let[m,S]of[["steady","steady_N"],["peak","peak_N"]]){let C=u(S);C!==null&&d.push(`${m} ${Ye(C,"N",i,3)}`)}s.rating_N!==null&&d.push(`may carry ${Ye(s.rating_N,"N",i,3)}`);let f=Array.from(o).reduce((m,S)=>S>m?S:m,h??0),{symbol:p,factor:_}=kt("N",i,f),g=s.rating_N!==null&&s.rating_N<4*f?{label:"rating",value:s.rating_N*_}:void 0;return{title:s.name,facts:d,label:`load, ${p}`,time:a,values:t0(o,_),limit:g}}var fM=1.5;function i0(n,e,t,i,s){if(!n.path||!n.chain)return null;let r=n.chain.length_m.reduce((p,_)=>Math.max(p,_),0),o=t.segmentsAt(n.path.at(e),Math.max(1,fM*r)),a=t.frames.history(i.field,p=>Math.max(0,o[p])),l=a?a.map((p,_)=>o[_]<0?NaN:p):[],c=Array.from(l).filter(p=>Number.isFinite(p)),u=c.reduce((p,_)=>Math.max(p,_),-1/0),{symbol:h,factor:d}=kt(i.unit,s,Math.max(Math.abs(u),0)),f=c.length>0?[]:["nothing passes there"];return c.length>0&&f.push(`largest ${Ye(u,i.unit,s,3)}`),{title:`Place ${Ui(e,s)}`,facts:f,label:`${i.title.toLowerCase()}${h?`, ${h}`:""}`,time:t.frames.time,values:t0(l,d)}}function ac(n,e,t){let i=n.headPlace(),s=n.largestTension,r=s?e.path?.nearest(n.centre(s.segment)):void 0,o=[`At ${Aa(n.time,n.frames.to)}`],a=[i===null?"the head is off the route":`the head is at ${Ui(i,t)}`];if(s&&s.value>0){let l=!r||r.distance>3?"off the route":`at ${Ui(r.s,t)}`;a.push(`the largest tension is ${Ye(s.value,"N",t,3)} ${l}`)}return`${o.join("")} ${a.join(", ")}.`}var oc=class{constructor(e,t){this.visible=e;this.spoken=t}visible;spoken;timer=0;last=0;tell(e,t){let i=performance.now();(i-this.last>200||!t)&&(this.visible.textContent=e(),this.last=i),clearTimeout(this.timer),this.timer=window.setTimeout(()=>this.spoken.textContent=e(),pM)}dispose(){clearTimeout(this.timer)}},pM=700;var mM=2,gM={"font-size":12,"text-anchor":"middle","paint-order":"stroke",stroke:"#fff","stroke-width":4};function _M(n,e,t,i){let s=e.shown().flatMap(({text:o,x:a,y:l,aside:c})=>[Qe("circle",{cx:a,cy:l,r:2,fill:"#000"}),Qe("text",{x:a+c,y:l-10,...gM},o)]),r=Qe("image",{href:n,width:t,height:i});return Qe("svg",{viewBox:`0 0 ${t} ${i}`,class:"view-still",role:"img"},r,...s)}function s0(n,e){let{world:t,now:i,playback:s,model:r}=n,o=i?.frames.timeOfLargest("tension")??null;if(!t||!i||o===null)return null;let{stage:a}=t,l={time:s.time,pose:a.goal};t.paint("light"),n.preset(0,!0),n.showAt(o);let c=a.shot(mM),u=_M(c,t.labels,a.width,a.height),h=ac(i,r,e.get("units")),d=n.legend.root.cloneNode(!0);return t.paint(e.get("theme")),n.showAt(l.time),a.go(l.pose,!0),A("div",{class:"view-paper view3d"},u,d,A("p",{class:"caption"},h))}var kd=100,lc=class{constructor(e,t,i){this.of=e;let s=A("input",{type:"range",min:0,max:kd,step:5,value:kd,class:"view-thick"});s.setAttribute("aria-label","How solid the environment is drawn"),s.addEventListener("input",()=>{t.fade(s.valueAsNumber/kd),i()});let r=(c,u)=>{let h=A("input",{type:"checkbox",checked:!0});return h.addEventListener("change",()=>{u(h.checked),i()}),[A("label",{class:"view-field"},h,c),h]},[o]=r("cut away toward the camera",c=>t.cut(c)),a=e.layers.map((c,u)=>r(c||"without a name",h=>{t.shown[u]=h,t.choose()})),[l]=r("all layers",c=>{a.forEach(([,u])=>u.checked=c),t.shown.fill(c),t.choose()});this.root=A("details",{class:"view-layers"},A("summary",{},"Environment"),A("label",{class:"view-field"},"faded",s,"solid"),o,A("div",{class:"view-layer-list",role:"group","aria-label":"Layers of the environment"},l,...a.map(([c])=>c)),this.exact)}of;root;exact=A("p",{class:"view-legend-note"});units(e){let{given:t,n_triangles:i,error_m:s,step_m:r}=this.of,o=l=>Ye(l,"mm",e,2),a=l=>ma(String(l));this.exact.textContent=i<t?`${a(i)} triangles of ${a(t)}, at most ${o((s??0)+r)} from them`:`all ${a(t)} triangles, corners rounded to ${o(r)}`}};function r0(n,e){let t=null,i=0,s=null,r=l=>{let c=n.getBoundingClientRect();return{x:l.clientX-c.left,y:l.clientY-c.top}},o=()=>{i=0,s&&e.hover(s.x,s.y)},a={pointerdown:l=>t=r(l),pointermove:l=>{s=l.buttons===0?r(l):null,i||=requestAnimationFrame(o)},pointerleave:()=>{s=null,e.leave()},click:l=>{let{x:c,y:u}=r(l);t&&Math.hypot(c-t.x,u-t.y)<4&&e.click(c,u)},dblclick:l=>{let{x:c,y:u}=r(l);e.double(c,u)}};for(let[l,c]of Object.entries(a))n.addEventListener(l,c);return()=>{cancelAnimationFrame(i);for(let[l,c]of Object.entries(a))n.removeEventListener(l,c)}}var o0=.05,a0=200;function xM(n){let e=n.chain?.segments??n.states?.segments??0;if(e===0)return null;let t=n.chain;return{segments:e,length_m:t?.length_m??new Array(e).fill(1),diameter_m:t?.diameter_m??new Array(e).fill(o0),part:t?.part??new Array(e).fill(0)}}function cc(n){let e=n.geometry??null,t=e?.route.position_m??[],i=h=>{let d=t.map(_=>_[h]),f=d.reduce((_,g)=>Math.min(_,g),1/0),p=d.reduce((_,g)=>Math.max(_,g),-1/0);return d.length>0?.5*(f+p):0},s=[i(0),i(1),i(2)],r=h=>vt(h,s),o=t.map(r),a=xM(n),l=a?a.part.lastIndexOf(0):-1,c=Math.max(1,Math.floor(o.length/a0)),u=o.filter((h,d)=>d%c===0||d===o.length-1);if(e?.reel&&u.push(r(e.reel.center_m)),e?.winch&&yM(o,r(e.winch.position_m))&&u.push(r(e.winch.position_m)),u.length===0){let h=a?a.length_m.reduce((d,f)=>d+f,0):1;u.push([-h,0,0],[h,0,0])}return{run:n,centre:s,at:r,path:e&&o.length>1?new jl(e.route.s_m,o):null,bends:e?qg(e.route.s_m,e.route.curvature_per_m,Xg(o)):[],chain:a,head:a?l>=0?l:a.segments-1:0,diameter:a?.diameter_m[Math.max(0,l)]??o0,extent:u}}function yM(n,e){let t=n[n.length-1];return!!t&&si(vt(e,t))<.5*si(vt(t,n[0]))}function l0(n,e){let t=n.fields.get("position");if(!t||e.path)return;let i=[];for(let r=0;r<n.items;r+=Math.max(1,Math.floor(n.items/a0)))i.push([0,1,2].map(o=>t.q[3*r+o]*t.meta.step));i.reduce((r,o)=>[r[0]+o[0],r[1]+o[1],r[2]+o[2]],[0,0,0]).forEach((r,o)=>e.centre[o]=r/i.length),e.extent=i.map(e.at)}function c0(n){let e=n.run.geometry?.reel;if(!e)return()=>!1;let[t,i,s]=n.at(e.center_m),[r,o,a]=Bd(e.axis);return(l,c,u)=>{let h=(l-t)*r+(c-i)*o+(u-s)*a,d=(l-t)**2+(c-i)**2+(u-s)**2-h*h;return Math.abs(h)<.6*e.width_m+.2&&d<(1.02*e.radius_m)**2}}var Bd=n=>Nt(n,[0,1,0]);var Ao=class{constructor(e,t){this.frames=e;this.model=t;this.centres=new Float32Array(3*e.items),this.values=new Float32Array(e.items),this.tension=new Float32Array(e.items)}frames;model;centres;values;tension;time=0;show(e,t){let i=this.frames.between(e);return this.frames.sample("position",i,this.centres,this.model.centre)?(this.frames.sample(t,i,this.values)||this.values.fill(0),this.frames.sample("tension",i,this.tension),this.time=e,!0):!1}centre(e){let t=this.centres;return[t[3*e],t[3*e+1],t[3*e+2]]}get largestTension(){if(!this.frames.fields.has("tension"))return null;let e=0;for(let t=1;t<this.tension.length;t++)this.tension[t]>this.tension[e]&&(e=t);return{segment:e,value:this.tension[e]}}headPlace(e=this.time){let t=this.model.run.states?.head_at_m??[],{frame:i,next:s,part:r}=this.frames.between(e),o=t[i]??null,a=t[s]??null;return o!==null&&a!==null?o+r*(a-o):this.model.path?.nearest(this.centre(this.model.head)).s??null}segmentsAt(e,t){let i=this.frames.fields.get("position"),s=new Int32Array(this.frames.count).fill(-1);if(!i)return s;let{q:r,meta:o}=i,[a,l,c]=e.map((h,d)=>(h+this.model.centre[d])/o.step),u=3*this.frames.items;for(let h=0;h<this.frames.count;h++){let d=(t/o.step)**2;for(let f=0,p=h*u;f<this.frames.items;f++,p+=3){let _=(r[p]-a)**2+(r[p+1]-l)**2+(r[p+2]-c)**2;_<d&&(d=_,s[h]=f)}}return s}};var uc=class{constructor(e,t){this.runs=e;this.models=e.map(i=>({...cc(i),centre:t.centre,at:t.at})),this.nows=e.map(()=>null)}runs;models;nows;arrived(e,t){this.nows[e]??=new Ao(t,this.models[e])}show(e,t){for(let i of this.nows)i?.show(e,t)}};function u0(n,e,t=()=>!1){let i=n.fields.get(e);if(!i)return null;let{q:s,meta:r}=i,o=1/0,a=-1/0,l=m=>{for(let S=0;S<n.count;S++)for(let C=0;C<n.items;C++)t(C,S)||m(s[S*n.items+C])};if(l(m=>{m<o&&(o=m),m>a&&(a=m)}),o>a)return null;let c=new Uint32Array(2048),u=0,h=Math.max(1,a-o)/2047;l(m=>{c[Math.floor((m-o)/h)]++,u++});let d=0;for(let m=c[0];m<.998*u&&d<2047;)m+=c[++d];let f=o+(d+1)*h,p=a>0&&a-o>2*(f-o),_=Math.min(0,o)*r.step,g=(p?f:a)*r.step;return{low:_,high:g>_?g:_+r.step,beyond:p?a*r.step:null}}function hc(n,e,t){let i=(e-n)/Math.max(1,t);if(!(i>0))return[];let s=10**Math.floor(Math.log10(i)),r=s*([1,2,5,10].find(a=>a*s>=i)??10),o=[];for(let a=Math.ceil(n/r-1e-9)+0;a*r<=e*(1+1e-12)+1e-9*r;a++)o.push(a*r);return o}var dc=class{constructor(e){this.model=e;let t=e.run.states?.packed,i=Od.filter(({field:s})=>t&&s in t);this.choices=i.length>0?i:Od,this.quantity=this.choices[0]}model;choices;quantity;scales=new Map;grown(){this.scales.clear()}choose(e){this.quantity=this.choices.find(t=>t.field===e)??this.quantity}get next(){return this.choices[(this.choices.indexOf(this.quantity)+1)%this.choices.length]}scale(e){let{field:t}=this.quantity;return e?.fields.has(t)&&!this.scales.has(t)&&this.scales.set(t,u0(e,t,this.wound(e))),this.scales.get(t)??null}wound(e){let t=e.fields.get("position");if(!this.model.run.geometry?.reel||!t)return;let i=c0(this.model),[s,r,o]=this.model.centre,{q:a,meta:l}=t;return(c,u)=>{let h=3*(u*e.items+c);return i(a[h]*l.step-s,a[h+1]*l.step-r,a[h+2]*l.step-o)}}};var vM=116,bM="11px system-ui",MM={light:{text:"#3b4650",grid:"#d9dfe5",line:"#1f6f8b",limit:"#c2410c"},dark:{text:"#c3ccd5",grid:"#2d3742",line:"#4fb3d4",limit:"#f08c4a"}},fc=class{constructor(e,t){this.seek=e;this.close=t}seek;close;root=A("section",{class:"view-inspector","aria-label":"Picked in the picture",hidden:!0});plot=null;time=NaN;show(e,t){if(this.plot?.destroy(),this.plot=null,this.root.hidden=!e,!e)return;let i=A("div",{class:"view-inspector-figure"});this.root.replaceChildren(A("header",{},A("strong",{},A("bdi",{},e.title.slice(0,80))),ni("\xD7",this.close,{"aria-label":"Close",title:"Close (Esc)"})),A("p",{},e.facts.join(" \xB7 ")),A("p",{class:"view-inspector-label"},`${e.label}, over time, s`),i),Array.from(e.values).some(r=>Number.isFinite(r))?this.plot=this.draw(i,e,t):i.append(A("p",{},"No figures over time in these data."))}draw(e,t,i){let s=MM[i],r={stroke:s.text,grid:{stroke:s.grid,width:1},ticks:{stroke:s.grid,width:1},font:bM},o=Array.from(t.values,u=>Number.isFinite(u)?u:null),a=[Array.from(t.time),o],l=[{},{label:t.label,stroke:s.line,width:1.5,points:{show:!1}}];t.limit&&(a.push(o.map(()=>t.limit?.value??null)),l.push({label:t.limit.label,stroke:s.limit,width:1,dash:[6,4],points:{show:!1}}));let c=new wn({width:Math.max(200,e.clientWidth),height:vM,legend:{show:!1},cursor:{drag:{x:!1,y:!1},y:!1},scales:{x:{time:!1}},axes:[{...r,size:20,gap:2},{...r,size:46}],series:l,hooks:{draw:[u=>this.line(u,s.limit)]}},a,e);return c.over.addEventListener("click",u=>this.seek(c.posToVal(u.offsetX,"x"))),c}line(e,t){if(!Number.isFinite(this.time))return;let i=e.valToPos(this.time,"x",!0);e.ctx.save(),e.ctx.strokeStyle=t,e.ctx.beginPath(),e.ctx.moveTo(i,e.bbox.top),e.ctx.lineTo(i,e.bbox.top+e.bbox.height),e.ctx.stroke(),e.ctx.restore()}at(e){this.time=e,this.plot?.redraw(!1,!1)}dispose(){this.plot?.destroy()}};var pc=[4456788,4725356,4665213,4277383,3757708,3238030,2783374,2328718,2070667,2271364,3520377,5555560,8048977,10869558,13820443,16639781];function SM(n){let e=pc.length-1,t=Math.min(1,Math.max(0,Number.isNaN(n)?0:n))*e,i=Math.min(e-1,Math.floor(t)),s=t-i,r=pc[i],o=pc[i+1],a=l=>{let c=r>>l&255;return c+s*((o>>l&255)-c)};return[a(16),a(8),a(0)]}function h0(n){let e=new Uint8Array(4*n);for(let t=0;t<n;t++)e.set([...SM(t/(n-1)).map(Math.round),255],4*t);return e}function d0(n){let e=pc.map(t=>`#${t.toString(16).padStart(6,"0")}`);return`linear-gradient(${n}, ${e.join(", ")})`}var mc=class{title=A("div",{class:"view-legend-title"});bar=A("div",{class:"view-legend-bar"});ticks=A("div",{class:"view-legend-ticks"});beyond=A("div",{class:"view-legend-note"});factor=A("div",{class:"view-legend-note"});grid=A("div",{class:"view-legend-note"});root;constructor(){this.bar.style.background=d0("to right");let e=A("div",{class:"view-legend-scale"},this.bar,this.ticks);this.root=A("div",{class:"view-legend"},this.title,e,this.beyond,this.factor,this.grid)}scale(e,t,i){if(this.bar.hidden=this.ticks.hidden=!t,this.beyond.textContent="",!t){this.title.textContent=`${e.title}: not in these data`;return}let{symbol:s,factor:r}=kt(e.unit,i,t.high);this.title.textContent=`${e.title}, ${s}`;let o=t.low*r,a=t.high*r;this.ticks.replaceChildren(...hc(o,a,4).map(l=>{let c=A("span",{},fn(l,3));return c.style.left=`${100*(l-o)/(a-o)}%`,c})),t.beyond!==null&&(this.beyond.textContent=`single peaks to ${fn(t.beyond*r,3)} ${s} have the last colour`)}sizes(e,t,i){let s=e<10?e.toFixed(e<1.05?0:1).replace(".0",""):e.toFixed(0);this.factor.textContent=e<1.05?"true diameter":`diameter \xD7 ${s}, rollers and ducts with it`;let{symbol:r,factor:o}=kt("m",i,t);this.grid.textContent=`grid ${fn(t*o,3)} ${r}`}};var f0=10,p0=40,wM=n=>n.length>p0?`${n.slice(0,p0)}\u2026`:n;function m0(n,e,t){let{path:i,run:s,bends:r}=e,o=s.geometry,a=(l,c,u,h,d="name")=>n.set(l,{text:c,point:u,weight:h,kind:d});if(i){let{factor:l}=kt("m",t,1),c=hc(i.from*l,i.to*l,f0);for(let u=0;u<3*f0;u++){let h=(c[u]??0)/l,d=Ui(h,t).replace(".0","");n.set(`distance${u}`,u<c.length?{text:d,point:i.at(h),weight:10,kind:"distance"}:null)}r.forEach((u,h)=>a(`bend${h}`,ic(u,t),i.at(.5*(u.from+u.to)),20+u.angle));for(let u of o?.conveyors??[])a(`conveyor ${u.name}`,wM(u.name),i.at(.5*(u.from_m+u.to_m)),40)}o?.reel&&a("reel","Reel",e.at(o.reel.center_m),60),o?.winch&&a("winch","Winch",e.at(o.winch.position_m),60)}var Ss=[.1,.25,.5,1,2,5,10,20,50,100,200,500,1e3],TM=25,EM=n=>Ss.find(e=>e>=1&&n/e<=TM*1.2)??Ss[Ss.length-1],gc=class{constructor(e,t){this.from=e;this.to=t;this.time=e,this.rate=EM(t-e)}from;to;playing=!1;rate;time;seek(e){this.time=Math.min(this.to,Math.max(this.from,e))}toggle(){this.playing=!this.playing,this.playing&&this.time>=this.to&&(this.time=this.from)}advance(e){return this.playing?(this.seek(this.time+this.rate*Math.min(e,.25)),this.time>=this.to&&(this.playing=!1),!0):!1}};var Ra={play:"M4 2.5v11l9-5.5z",pause:"M4 3h3v10H4zM9 3h3v10H9z",before:"M3 3h2v10H3zM13 3v10L6 8z",next:"M11 3h2v10h-2zM3 3v10l7-5z"},g0=n=>Qe("svg",{width:14,height:14,viewBox:"0 0 16 16","aria-hidden":"true"},Qe("path",{d:n,fill:"currentColor"})),Vd=(n,e,t,i)=>A("button",{type:"button","aria-label":e,title:`${e} (${t})`,"aria-keyshortcuts":t,onclick:i},g0(n)),zd=4e3,_c=class{constructor(e,t,i){this.playback=e;this.play=Vd(Ra.play,"Play","Space",()=>i.toggle()),this.slider.setAttribute("aria-label","Simulated time"),this.slider.addEventListener("input",()=>i.seek(this.timeOf(this.slider.valueAsNumber))),this.followBox.addEventListener("change",()=>i.follow(this.followBox.checked));let s=this.rates=A("select",{title:"Simulated seconds a second"},...Ss.map(a=>A("option",{value:a},`${a}\xD7`)));s.value=String(e.rate),s.addEventListener("change",()=>e.rate=Number(s.value));let r=A("select",{class:"view-jump","aria-label":"Jump to an event"},A("option",{value:""},"Jump to\u2026"),...t.map((a,l)=>A("option",{value:l},`${Aa(a.time_s,e.to)}  ${a.what.slice(0,80)}`)));r.addEventListener("change",()=>{let a=t[Number(r.value)];r.value&&a&&i.seek(a.time_s),r.value=""});let o=A("div",{class:"view-track"},this.slider,this.ticks(t));this.root=A("div",{class:"view-player"},this.play,Vd(Ra.before,"Event before","Shift+E",()=>i.event(-1)),Vd(Ra.next,"Next event","E",()=>i.event(1)),o,this.reading,A("label",{class:"view-field"},"Speed",s),r,A("label",{class:"view-field",title:"Camera goes with the head (F)"},this.followBox,"Follow head"))}playback;root;play;rates;slider=A("input",{type:"range",min:0,max:zd,step:"any",class:"view-time"});reading=A("output",{class:"view-reading"});followBox=A("input",{type:"checkbox"});timeOf(e){let{from:t,to:i}=this.playback;return t+(i-t)*e/zd}ticks(e){let{from:t,to:i}=this.playback;return A("div",{class:"view-ticks","aria-hidden":"true"},...e.map(s=>{let r=A("i");return r.style.left=`${100*(s.time_s-t)/Math.max(1e-9,i-t)}%`,r}))}update(){let{time:e,from:t,to:i,playing:s}=this.playback;this.slider.valueAsNumber=zd*(e-t)/Math.max(1e-9,i-t);let r=Aa(e,i);this.reading.textContent!==r&&(this.reading.textContent=r,this.slider.setAttribute("aria-valuetext",r));let o=s?"Pause":"Play";this.play.getAttribute("aria-label")!==o&&(this.play.replaceChildren(g0(s?Ra.pause:Ra.play)),this.play.setAttribute("aria-label",o))}following(e){this.followBox.checked=e}rated(){this.rates.value=String(this.playback.rate)}};var xc=class{constructor(e,t,i,s=[]){this.store=t;this.narrator=i;this.model=cc(e),this.beside=new uc(s,this.model),this.colouring=new dc(this.model);let r=e.states?.time_s??[];this.playback=new gc(r[0]??0,r[r.length-1]??0),this.events=(e.summary.events??[]).filter(o=>Number.isFinite(o.time_s)),this.inspector=new fc(o=>this.seek(o),()=>this.leave()),this.player=new _c(this.playback,this.events,this),this.tools=new sc(this.model.bends,this.colouring.choices,this)}store;narrator;model;beside;playback;legend=new mc;inspector;player;tools;now=null;world=null;cameras=null;forces=null;colouring;events;stale=!0;choice=null;hovered=-1;request=0;draws(e,t){this.world=e,this.cameras=t,t.onChange=(i,s)=>{this.tools.atBend(i),this.player.following(s)},e.stage.onFrame=i=>this.tick(i)}arrived(e,t){t==="position"&&(this.now=new Ao(e,this.model),l0(e,this.model),this.model.path||this.preset(0,!0)),t===this.colouring.quantity.field&&this.colour(t),this.refresh()}grown(e){let{playback:t}=this,i=t.time>=t.to-1e-9;t.to=e.to,i&&!t.playing&&t.seek(e.to),this.colouring.grown();for(let s of e.fields.keys())this.arrived(e,s)}besideArrived(e,t){this.beside.arrived(e,t),this.refresh()}refresh(){this.stale=!0,this.world?this.world.stage.invalidate():this.request||=requestAnimationFrame(()=>this.unseen())}unseen(){this.request=0,this.tick(1/60)&&this.refresh()}tick(e){let{playback:t,now:i,world:s}=this;return t.advance(e)&&(this.stale=!0,this.store.set("time",t.time,this)),i&&this.stale&&i.show(t.time,this.colouring.quantity.field)&&this.cameras?.goWithHead(i),this.stale&&this.beside.show(t.time,this.colouring.quantity.field),s?.update(this.stale?i:null),i&&this.stale&&this.tell(i),this.stale=!1,this.player.update(),s&&(s.updateLabels(),this.legend.sizes(s.factor,s.ground.spacing,this.store.get("units"))),t.playing}tell(e){let t=this.store.get("units"),i=this.world?.labels,s=e.largestTension;if(i?.set("head",{text:"Head",point:e.centre(this.model.head),weight:90,kind:"head"}),s&&i){let r=`Largest ${Ye(s.value,"N",t,3)}`;i.set("largest",{text:r,point:e.centre(s.segment),weight:95,kind:"largest"})}this.narrator.tell(()=>ac(e,this.model,t),this.playback.playing),this.inspector.at(e.time)}showAt(e){this.playback.seek(e),this.refresh()}seek(e){this.playback.seek(e),this.store.set("time",this.playback.time,this),this.refresh()}toggle(){this.playback.toggle(),this.refresh()}step(e){let t=this.now?.frames;if(!t)return;this.playback.playing=!1;let{frame:i,part:s}=t.between(this.playback.time),r=e<0&&s>1e-6?i+1:i;this.seek(t.time[Math.min(t.count-1,Math.max(0,r+e))])}end(e){this.seek(e?this.playback.to:this.playback.from)}faster(e){let t=Ss.indexOf(this.playback.rate)+e;this.playback.rate=Ss[Math.min(Ss.length-1,Math.max(0,t))],this.player.rated()}event(e){let{time:t}=this.playback,i=this.events.map(r=>r.time_s).sort((r,o)=>r-o),s=e>0?i.find(r=>r>t+1e-6):i.filter(r=>r<t-1e-6).pop();s!==void 0&&this.seek(s)}zoom(e){this.world?.stage.zoom(e)}orbit(e,t){this.world?.stage.orbit(e,t)}factor(e){this.world?.exaggerate(e)}preset(e,t=!1){this.cameras?.preset(e,this.place,t)}bend(e){this.cameras?.bend(e)}nextBend(e){this.cameras?.nextBend(e)}follow(e){this.cameras?.follow(e)}toPlace(e=this.place){e!==null&&this.model.path&&this.cameras?.lookAt(this.model.path.at(e))}colour(e){let{colouring:t}=this;t.choose(e);let i=t.scale(this.now?.frames);this.tools.coloured(e),this.world?.scale(i),this.legend.scale(t.quantity,i,this.store.get("units")),this.choice&&"place"in this.choice&&this.inspect(this.choice),this.refresh()}nextColour(){this.colour(this.colouring.next.field)}get place(){return this.store.get("place")??(this.choice&&"place"in this.choice?this.choice.place:null)}inspect(e){this.choice=e;let{model:t,now:i}=this,s=this.store.get("units"),r=e&&"roller"in e?e.roller:null;this.store.set("roller",r,this);let o=e&&"place"in e&&i,a=r!==null?n0(t,r,this.forces,s):o?i0(t,e.place,i,this.colouring.quantity,s):null;this.inspector.show(a,this.store.get("theme")),this.world?.rollers?.mark(r??-1,-1),this.mark()}inspectAgain(){this.choice&&this.inspect(this.choice)}leave(){this.inspect(null)}hover(e){this.hovered=e,this.mark()}mark(){let{model:e,world:t,place:i,hovered:s}=this,r=e.run.geometry?.rollers[s]?.name.slice(0,60),o=i===null?"":Ui(i,this.store.get("units")),a=r?t?.rollers?.centre(s):i===null?void 0:e.path?.at(i),l=[r,o].filter(Boolean).join(" \xB7 ");t?.labels.set("place",a?{text:l,point:a,weight:200,kind:"place"}:null),t?.stage.invalidate()}redress(){let e=this.store.get("units");this.tools.units(e),this.world&&(m0(this.world.labels,this.model,e),this.world.unit=1/kt("m",e,1).factor,this.world.paint(this.store.get("theme"))),this.colour(this.colouring.quantity.field),this.inspectAgain(),this.mark()}dispose(){cancelAnimationFrame(this.request),this.narrator.dispose(),this.inspector.dispose(),this.world?.dispose()}};var ur={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},hr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},V0=0,vf=1,z0=2;var rl=1,G0=2,Zo=3,ji=0,oi=1,$n=2,fs=0,Gr=1,bf=2,Mf=3,Sf=4,H0=5;var nr=100,W0=101,X0=102,q0=103,$0=104,Y0=200,Z0=201,K0=202,J0=203,Wc=204,Xc=205,j0=206,Q0=207,e_=208,t_=209,n_=210,i_=211,s_=212,r_=213,o_=214,qc=0,$c=1,Yc=2,Hr=3,Zc=4,Kc=5,Jc=6,jc=7,wf=0,a_=1,l_=2,es=0,Tf=1,Ef=2,Af=3,Cf=4,Rf=5,Pf=6,If=7;var Lf=300,dr=301,qr=302,wu=303,Tu=304,ol=306,Qc=1e3,us=1001,eu=1002,vn=1003,c_=1004;var al=1005;var En=1006,Eu=1007;var fr=1008;var Ri=1009,Nf=1010,Df=1011,Ko=1012,Au=1013,ts=1014,Pi=1015,ps=1016,Cu=1017,Ru=1018,Jo=1020,Ff=35902,Uf=35899,Of=1021,kf=1022,ai=1023,hs=1026,pr=1027,Bf=1028,Pu=1029,mr=1030,Iu=1031;var Lu=1033,ll=33776,cl=33777,ul=33778,hl=33779,Nu=35840,Du=35841,Fu=35842,Uu=35843,Ou=36196,ku=37492,Bu=37496,Vu=37488,zu=37489,dl=37490,Gu=37491,Hu=37808,Wu=37809,Xu=37810,qu=37811,$u=37812,Yu=37813,Zu=37814,Ku=37815,Ju=37816,ju=37817,Qu=37818,eh=37819,th=37820,nh=37821,ih=36492,sh=36494,rh=36495,oh=36283,ah=36284,fl=36285,lh=36286;var Oa=2300,tu=2301,Hc=2302,hf=2303,df=2400,ff=2401,pf=2402;var u_=3200;var Vf=0,h_=1,Ns="",Ti="srgb",ka="srgb-linear",Ba="linear",Dt="srgb";var Vr=7680;var mf=519,d_=512,f_=513,p_=514,ch=515,m_=516,g_=517,uh=518,__=519,gf=35044;var zf="300 es",Ji=2e3,Va=2001;function AM(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function CM(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function za(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function x_(){let n=za("canvas");return n.style.display="block",n}var _0={},Go=null;function Gf(...n){let e="THREE."+n.shift();Go?Go("log",e,...n):console.log(e,...n)}function y_(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function $e(...n){n=y_(n);let e="THREE."+n.shift();if(Go)Go("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function Je(...n){n=y_(n);let e="THREE."+n.shift();if(Go)Go("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function zr(...n){let e=n.join(" ");e in _0||(_0[e]=!0,$e(...n))}function v_(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var b_={[qc]:$c,[Yc]:Jc,[Zc]:jc,[Hr]:Kc,[$c]:qc,[Jc]:Yc,[jc]:Zc,[Kc]:Hr},Qi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Hn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],x0=1234567,Fa=Math.PI/180,Ho=180/Math.PI;function jo(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Hn[n&255]+Hn[n>>8&255]+Hn[n>>16&255]+Hn[n>>24&255]+"-"+Hn[e&255]+Hn[e>>8&255]+"-"+Hn[e>>16&15|64]+Hn[e>>24&255]+"-"+Hn[t&63|128]+Hn[t>>8&255]+"-"+Hn[t>>16&255]+Hn[t>>24&255]+Hn[i&255]+Hn[i>>8&255]+Hn[i>>16&255]+Hn[i>>24&255]).toLowerCase()}function ut(n,e,t){return Math.max(e,Math.min(t,n))}function Hf(n,e){return(n%e+e)%e}function RM(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function PM(n,e,t){return n!==e?(t-n)/(e-n):0}function Ua(n,e,t){return(1-t)*n+t*e}function IM(n,e,t,i){return Ua(n,e,1-Math.exp(-t*i))}function LM(n,e=1){return e-Math.abs(Hf(n,e*2)-e)}function NM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function DM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function FM(n,e){return n+Math.floor(Math.random()*(e-n+1))}function UM(n,e){return n+Math.random()*(e-n)}function OM(n){return n*(.5-Math.random())}function kM(n){n!==void 0&&(x0=n);let e=x0+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function BM(n){return n*Fa}function VM(n){return n*Ho}function zM(n){return(n&n-1)===0&&n!==0}function GM(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function HM(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function WM(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),h=r((e-i)/2),d=o((e-i)/2),f=r((i-e)/2),p=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*u,a*c);break;default:$e("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Vo(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("THREE.MathUtils: Invalid component type.")}}function ri(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("THREE.MathUtils: Invalid component type.")}}var Wf={DEG2RAD:Fa,RAD2DEG:Ho,generateUUID:jo,clamp:ut,euclideanModulo:Hf,mapLinear:RM,inverseLerp:PM,lerp:Ua,damp:IM,pingpong:LM,smoothstep:NM,smootherstep:DM,randInt:FM,randFloat:UM,randFloatSpread:OM,seededRandom:kM,degToRad:BM,radToDeg:VM,isPowerOfTwo:zM,ceilPowerOfTwo:GM,floorPowerOfTwo:HM,setQuaternionFromProperEuler:WM,normalize:ri,denormalize:Vo},je=class n{static{n.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ut(this.x,e.x,t.x),this.y=ut(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ut(this.x,e,t),this.y=ut(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ut(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ut(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},qn=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],_=r[o+3];if(h!==_||l!==d||c!==f||u!==p){let g=l*d+c*f+u*p+h*_;g<0&&(d=-d,f=-f,p=-p,_=-_,g=-g);let m=1-a;if(g<.9995){let S=Math.acos(g),C=Math.sin(S);m=Math.sin(m*S)/C,a=Math.sin(a*S)/C,l=l*m+d*a,c=c*m+f*a,u=u*m+p*a,h=h*m+_*a}else{l=l*m+d*a,c=c*m+f*a,u=u*m+p*a,h=h*m+_*a;let S=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=S,c*=S,u*=S,h*=S}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+u*h+l*f-c*d,e[t+1]=l*p+u*d+c*h-a*f,e[t+2]=c*p+u*f+a*d-l*h,e[t+3]=u*p-a*h-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"YXZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"ZXY":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"ZYX":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"YZX":this._x=d*u*h+c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h-d*f*p;break;case"XZY":this._x=d*u*h-c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h+d*f*p;break;default:$e("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ut(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},z=class n{static{n.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(y0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(y0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ut(this.x,e.x,t.x),this.y=ut(this.y,e.y,t.y),this.z=ut(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ut(this.x,e,t),this.y=ut(this.y,e,t),this.z=ut(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ut(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Gd.copy(this).projectOnVector(e),this.sub(Gd)}reflect(e){return this.sub(Gd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ut(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Gd=new z,y0=new qn,it=class n{static{n.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],p=i[8],_=s[0],g=s[3],m=s[6],S=s[1],C=s[4],b=s[7],R=s[2],T=s[5],N=s[8];return r[0]=o*_+a*S+l*R,r[3]=o*g+a*C+l*T,r[6]=o*m+a*b+l*N,r[1]=c*_+u*S+h*R,r[4]=c*g+u*C+h*T,r[7]=c*m+u*b+h*N,r[2]=d*_+f*S+p*R,r[5]=d*g+f*C+p*T,r[8]=d*m+f*b+p*N,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,p=t*h+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/p;return e[0]=h*_,e[1]=(s*c-u*i)*_,e[2]=(a*i-s*o)*_,e[3]=d*_,e[4]=(u*t-s*l)*_,e[5]=(s*r-a*t)*_,e[6]=f*_,e[7]=(i*l-c*t)*_,e[8]=(o*t-i*r)*_,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return zr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Hd.makeScale(e,t)),this}rotate(e){return zr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Hd.makeRotation(-e)),this}translate(e,t){return zr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Hd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Hd=new it,v0=new it().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),b0=new it().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function XM(){let n={enabled:!0,workingColorSpace:ka,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Dt&&(s.r=Rs(s.r),s.g=Rs(s.g),s.b=Rs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Dt&&(s.r=zo(s.r),s.g=zo(s.g),s.b=zo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ns?Ba:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return zr("ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),n.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return zr("ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),n.colorSpaceToWorking(s,r)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ka]:{primaries:e,whitePoint:i,transfer:Ba,toXYZ:v0,fromXYZ:b0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Ti},outputColorSpaceConfig:{drawingBufferColorSpace:Ti}},[Ti]:{primaries:e,whitePoint:i,transfer:Dt,toXYZ:v0,fromXYZ:b0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Ti}}}),n}var xt=XM();function Rs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function zo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Co,nu=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Co===void 0&&(Co=za("canvas")),Co.width=e.width,Co.height=e.height;let s=Co.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Co}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=za("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Rs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Rs(t[i]/255)*255):t[i]=Rs(t[i]);return{data:t,width:e.width,height:e.height}}else return $e("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},qM=0,Wo=class{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:qM++}),this.uuid=jo(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Wd(s[o].image)):r.push(Wd(s[o]))}else r=Wd(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Wd(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?nu.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:($e("Texture: Unable to serialize Texture."),{})}var $M=0,Xd=new z,ui=class n extends Qi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=us,s=us,r=En,o=fr,a=ai,l=Ri,c=n.DEFAULT_ANISOTROPY,u=Ns){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:$M++}),this.uuid=jo(),this.name="",this.source=new Wo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new je(0,0),this.repeat=new je(1,1),this.center=new je(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new it,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.normalized=!1}get width(){return this.source.getSize(Xd).x}get height(){return this.source.getSize(Xd).y}get depth(){return this.source.getSize(Xd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){$e(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Lf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Qc:e.x=e.x-Math.floor(e.x);break;case us:e.x=e.x<0?0:1;break;case eu:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Qc:e.y=e.y-Math.floor(e.y);break;case us:e.y=e.y<0?0:1;break;case eu:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ui.DEFAULT_IMAGE=null;ui.DEFAULT_MAPPING=Lf;ui.DEFAULT_ANISOTROPY=1;var Qt=class n{static{n.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],p=l[9],_=l[2],g=l[6],m=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-_)<.01&&Math.abs(p-g)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+_)<.1&&Math.abs(p+g)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let C=(c+1)/2,b=(f+1)/2,R=(m+1)/2,T=(u+d)/4,N=(h+_)/4,v=(p+g)/4;return C>b&&C>R?C<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(C),s=T/i,r=N/i):b>R?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=T/s,r=v/s):R<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),i=N/r,s=v/r),this.set(i,s,r,t),this}let S=Math.sqrt((g-p)*(g-p)+(h-_)*(h-_)+(d-u)*(d-u));return Math.abs(S)<.001&&(S=1),this.x=(g-p)/S,this.y=(h-_)/S,this.z=(d-u)/S,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ut(this.x,e.x,t.x),this.y=ut(this.y,e.y,t.y),this.z=ut(this.z,e.z,t.z),this.w=ut(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ut(this.x,e,t),this.y=ut(this.y,e,t),this.z=ut(this.z,e,t),this.w=ut(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ut(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},iu=class extends Qi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:En,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Qt(0,0,e,t),this.scissorTest=!1,this.viewport=new Qt(0,0,e,t),this.textures=[];let s={width:e,height:t,depth:i.depth},r=new ui(s),o=i.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:En,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Wo(s)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ai=class extends iu{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Ga=class extends ui{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=vn,this.minFilter=vn,this.wrapR=us,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var su=class extends ui{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=vn,this.minFilter=vn,this.wrapR=us,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Vt=class n{static{n.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,d,f,p,_,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,d,f,p,_,g)}set(e,t,i,s,r,o,a,l,c,u,h,d,f,p,_,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=h,m[14]=d,m[3]=f,m[7]=p,m[11]=_,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Ro.setFromMatrixColumn(e,0).length(),r=1/Ro.setFromMatrixColumn(e,1).length(),o=1/Ro.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let d=o*u,f=o*h,p=a*u,_=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=f+p*c,t[5]=d-_*c,t[9]=-a*l,t[2]=_-d*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,f=l*h,p=c*u,_=c*h;t[0]=d+_*a,t[4]=p*a-f,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=f*a-p,t[6]=_+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,f=l*h,p=c*u,_=c*h;t[0]=d-_*a,t[4]=-o*h,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*u,t[9]=_-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,f=o*h,p=a*u,_=a*h;t[0]=l*u,t[4]=p*c-f,t[8]=d*c+_,t[1]=l*h,t[5]=_*c+d,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,p=a*l,_=a*c;t[0]=l*u,t[4]=_-d*h,t[8]=p*h+f,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*h+p,t[10]=d-_*h}else if(e.order==="XZY"){let d=o*l,f=o*c,p=a*l,_=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+_,t[5]=o*u,t[9]=f*h-p,t[2]=p*h-f,t[6]=a*u,t[10]=_*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(YM,e,ZM)}lookAt(e,t,i){let s=this.elements;return Si.subVectors(e,t),Si.lengthSq()===0&&(Si.z=1),Si.normalize(),Zs.crossVectors(i,Si),Zs.lengthSq()===0&&(Math.abs(i.z)===1?Si.x+=1e-4:Si.z+=1e-4,Si.normalize(),Zs.crossVectors(i,Si)),Zs.normalize(),yc.crossVectors(Si,Zs),s[0]=Zs.x,s[4]=yc.x,s[8]=Si.x,s[1]=Zs.y,s[5]=yc.y,s[9]=Si.y,s[2]=Zs.z,s[6]=yc.z,s[10]=Si.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],p=i[2],_=i[6],g=i[10],m=i[14],S=i[3],C=i[7],b=i[11],R=i[15],T=s[0],N=s[4],v=s[8],E=s[12],F=s[1],I=s[5],U=s[9],k=s[13],X=s[2],O=s[6],$=s[10],H=s[14],ie=s[3],oe=s[7],le=s[11],de=s[15];return r[0]=o*T+a*F+l*X+c*ie,r[4]=o*N+a*I+l*O+c*oe,r[8]=o*v+a*U+l*$+c*le,r[12]=o*E+a*k+l*H+c*de,r[1]=u*T+h*F+d*X+f*ie,r[5]=u*N+h*I+d*O+f*oe,r[9]=u*v+h*U+d*$+f*le,r[13]=u*E+h*k+d*H+f*de,r[2]=p*T+_*F+g*X+m*ie,r[6]=p*N+_*I+g*O+m*oe,r[10]=p*v+_*U+g*$+m*le,r[14]=p*E+_*k+g*H+m*de,r[3]=S*T+C*F+b*X+R*ie,r[7]=S*N+C*I+b*O+R*oe,r[11]=S*v+C*U+b*$+R*le,r[15]=S*E+C*k+b*H+R*de,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],f=e[14],p=e[3],_=e[7],g=e[11],m=e[15],S=l*f-c*d,C=a*f-c*h,b=a*d-l*h,R=o*f-c*u,T=o*d-l*u,N=o*h-a*u;return t*(_*S-g*C+m*b)-i*(p*S-g*R+m*T)+s*(p*C-_*R+m*N)-r*(p*b-_*T+g*N)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],f=e[11],p=e[12],_=e[13],g=e[14],m=e[15],S=t*a-i*o,C=t*l-s*o,b=t*c-r*o,R=i*l-s*a,T=i*c-r*a,N=s*c-r*l,v=u*_-h*p,E=u*g-d*p,F=u*m-f*p,I=h*g-d*_,U=h*m-f*_,k=d*m-f*g,X=S*k-C*U+b*I+R*F-T*E+N*v;if(X===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let O=1/X;return e[0]=(a*k-l*U+c*I)*O,e[1]=(s*U-i*k-r*I)*O,e[2]=(_*N-g*T+m*R)*O,e[3]=(d*T-h*N-f*R)*O,e[4]=(l*F-o*k-c*E)*O,e[5]=(t*k-s*F+r*E)*O,e[6]=(g*b-p*N-m*C)*O,e[7]=(u*N-d*b+f*C)*O,e[8]=(o*U-a*F+c*v)*O,e[9]=(i*F-t*U-r*v)*O,e[10]=(p*T-_*b+m*S)*O,e[11]=(h*b-u*T-f*S)*O,e[12]=(a*E-o*I-l*v)*O,e[13]=(t*I-i*E+s*v)*O,e[14]=(_*C-p*R-g*S)*O,e[15]=(u*R-h*C+d*S)*O,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,p=r*h,_=o*u,g=o*h,m=a*h,S=l*c,C=l*u,b=l*h,R=i.x,T=i.y,N=i.z;return s[0]=(1-(_+m))*R,s[1]=(f+b)*R,s[2]=(p-C)*R,s[3]=0,s[4]=(f-b)*T,s[5]=(1-(d+m))*T,s[6]=(g+S)*T,s[7]=0,s[8]=(p+C)*N,s[9]=(g-S)*N,s[10]=(1-(d+_))*N,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Ro.set(s[0],s[1],s[2]).length(),a=Ro.set(s[4],s[5],s[6]).length(),l=Ro.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Yi.copy(this);let c=1/o,u=1/a,h=1/l;return Yi.elements[0]*=c,Yi.elements[1]*=c,Yi.elements[2]*=c,Yi.elements[4]*=u,Yi.elements[5]*=u,Yi.elements[6]*=u,Yi.elements[8]*=h,Yi.elements[9]*=h,Yi.elements[10]*=h,t.setFromRotationMatrix(Yi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Ji,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),d=(t+e)/(t-e),f=(i+s)/(i-s),p,_;if(l)p=r/(o-r),_=o*r/(o-r);else if(a===Ji)p=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===Va)p=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Ji,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),d=-(t+e)/(t-e),f=-(i+s)/(i-s),p,_;if(l)p=1/(o-r),_=o/(o-r);else if(a===Ji)p=-2/(o-r),_=-(o+r)/(o-r);else if(a===Va)p=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Ro=new z,Yi=new Vt,YM=new z(0,0,0),ZM=new z(1,1,1),Zs=new z,yc=new z,Si=new z,M0=new Vt,S0=new qn,ir=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(ut(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ut(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(ut(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ut(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ut(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ut(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:$e("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return M0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(M0,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return S0.setFromEuler(this),this.setFromQuaternion(S0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ir.DEFAULT_ORDER="XYZ";var Ha=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},KM=0,w0=new z,Po=new qn,ws=new Vt,vc=new z,Pa=new z,JM=new z,jM=new qn,T0=new z(1,0,0),E0=new z(0,1,0),A0=new z(0,0,1),C0={type:"added"},QM={type:"removed"},Io={type:"childadded",child:null},qd={type:"childremoved",child:null},hi=class n extends Qi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:KM++}),this.uuid=jo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new z,t=new ir,i=new qn,s=new z(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Vt},normalMatrix:{value:new it}}),this.matrix=new Vt,this.matrixWorld=new Vt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ha,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Po.setFromAxisAngle(e,t),this.quaternion.multiply(Po),this}rotateOnWorldAxis(e,t){return Po.setFromAxisAngle(e,t),this.quaternion.premultiply(Po),this}rotateX(e){return this.rotateOnAxis(T0,e)}rotateY(e){return this.rotateOnAxis(E0,e)}rotateZ(e){return this.rotateOnAxis(A0,e)}translateOnAxis(e,t){return w0.copy(e).applyQuaternion(this.quaternion),this.position.add(w0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(T0,e)}translateY(e){return this.translateOnAxis(E0,e)}translateZ(e){return this.translateOnAxis(A0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ws.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?vc.copy(e):vc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Pa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ws.lookAt(Pa,vc,this.up):ws.lookAt(vc,Pa,this.up),this.quaternion.setFromRotationMatrix(ws),s&&(ws.extractRotation(s.matrixWorld),Po.setFromRotationMatrix(ws),this.quaternion.premultiply(Po.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Je("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(C0),Io.child=e,this.dispatchEvent(Io),Io.child=null):Je("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(QM),qd.child=e,this.dispatchEvent(qd),qd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ws.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ws.multiply(e.parent.matrixWorld)),e.applyMatrix4(ws),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(C0),Io.child=e,this.dispatchEvent(Io),Io.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Pa,e,JM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Pa,jM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),this.static!==!1&&(s.static=this.static),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}};hi.DEFAULT_UP=new z(0,1,0);hi.DEFAULT_MATRIX_AUTO_UPDATE=!0;hi.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ei=class extends hi{constructor(){super(),this.isGroup=!0,this.type="Group"}},eS={type:"move"},Xo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ei,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ei,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ei,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new z,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let _ of e.hand.values()){let g=t.getJointPose(_,i),m=this._getHandJoint(c,_);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.rotation,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(eS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Ei;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},M_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ks={h:0,s:0,l:0},bc={h:0,s:0,l:0};function $d(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var pt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Ti){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,xt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=xt.workingColorSpace){return this.r=e,this.g=t,this.b=i,xt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=xt.workingColorSpace){if(e=Hf(e,1),t=ut(t,0,1),i=ut(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=$d(o,r,e+1/3),this.g=$d(o,r,e),this.b=$d(o,r,e-1/3)}return xt.colorSpaceToWorking(this,s),this}setStyle(e,t=Ti){function i(r){r!==void 0&&parseFloat(r)<1&&$e("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:$e("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);$e("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Ti){let i=M_[e.toLowerCase()];return i!==void 0?this.setHex(i,t):$e("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Rs(e.r),this.g=Rs(e.g),this.b=Rs(e.b),this}copyLinearToSRGB(e){return this.r=zo(e.r),this.g=zo(e.g),this.b=zo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Ti){return xt.workingToColorSpace(Wn.copy(this),e),Math.round(ut(Wn.r*255,0,255))*65536+Math.round(ut(Wn.g*255,0,255))*256+Math.round(ut(Wn.b*255,0,255))}getHexString(e=Ti){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=xt.workingColorSpace){xt.workingToColorSpace(Wn.copy(this),t);let i=Wn.r,s=Wn.g,r=Wn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=xt.workingColorSpace){return xt.workingToColorSpace(Wn.copy(this),t),e.r=Wn.r,e.g=Wn.g,e.b=Wn.b,e}getStyle(e=Ti){xt.workingToColorSpace(Wn.copy(this),e);let t=Wn.r,i=Wn.g,s=Wn.b;return e!==Ti?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Ks),this.setHSL(Ks.h+e,Ks.s+t,Ks.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Ks),e.getHSL(bc);let i=Ua(Ks.h,bc.h,t),s=Ua(Ks.s,bc.s,t),r=Ua(Ks.l,bc.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Wn=new pt;pt.NAMES=M_;var Wa=class extends hi{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ir,this.environmentIntensity=1,this.environmentRotation=new ir,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}},Zi=new z,Ts=new z,Yd=new z,Es=new z,Lo=new z,No=new z,R0=new z,Zd=new z,Kd=new z,Jd=new z,jd=new Qt,Qd=new Qt,ef=new Qt,tr=class n{constructor(e=new z,t=new z,i=new z){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Zi.subVectors(e,t),s.cross(Zi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Zi.subVectors(s,t),Ts.subVectors(i,t),Yd.subVectors(e,t);let o=Zi.dot(Zi),a=Zi.dot(Ts),l=Zi.dot(Yd),c=Ts.dot(Ts),u=Ts.dot(Yd),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,p=(o*u-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Es)===null?!1:Es.x>=0&&Es.y>=0&&Es.x+Es.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Es)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Es.x),l.addScaledVector(o,Es.y),l.addScaledVector(a,Es.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return jd.setScalar(0),Qd.setScalar(0),ef.setScalar(0),jd.fromBufferAttribute(e,t),Qd.fromBufferAttribute(e,i),ef.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(jd,r.x),o.addScaledVector(Qd,r.y),o.addScaledVector(ef,r.z),o}static isFrontFacing(e,t,i,s){return Zi.subVectors(i,t),Ts.subVectors(e,t),Zi.cross(Ts).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Zi.subVectors(this.c,this.b),Ts.subVectors(this.a,this.b),Zi.cross(Ts).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Lo.subVectors(s,i),No.subVectors(r,i),Zd.subVectors(e,i);let l=Lo.dot(Zd),c=No.dot(Zd);if(l<=0&&c<=0)return t.copy(i);Kd.subVectors(e,s);let u=Lo.dot(Kd),h=No.dot(Kd);if(u>=0&&h<=u)return t.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0)return o=l/(l-u),t.copy(i).addScaledVector(Lo,o);Jd.subVectors(e,r);let f=Lo.dot(Jd),p=No.dot(Jd);if(p>=0&&f<=p)return t.copy(r);let _=f*c-l*p;if(_<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(No,a);let g=u*p-f*h;if(g<=0&&h-u>=0&&f-p>=0)return R0.subVectors(r,s),a=(h-u)/(h-u+(f-p)),t.copy(s).addScaledVector(R0,a);let m=1/(g+_+d);return o=_*m,a=d*m,t.copy(i).addScaledVector(Lo,o).addScaledVector(No,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},sr=class{constructor(e=new z(1/0,1/0,1/0),t=new z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Ki.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Ki.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Ki.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ki):Ki.fromBufferAttribute(r,o),Ki.applyMatrix4(e.matrixWorld),this.expandByPoint(Ki);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Mc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Mc.copy(i.boundingBox)),Mc.applyMatrix4(e.matrixWorld),this.union(Mc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ki),Ki.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ia),Sc.subVectors(this.max,Ia),Do.subVectors(e.a,Ia),Fo.subVectors(e.b,Ia),Uo.subVectors(e.c,Ia),Js.subVectors(Fo,Do),js.subVectors(Uo,Fo),Ur.subVectors(Do,Uo);let t=[0,-Js.z,Js.y,0,-js.z,js.y,0,-Ur.z,Ur.y,Js.z,0,-Js.x,js.z,0,-js.x,Ur.z,0,-Ur.x,-Js.y,Js.x,0,-js.y,js.x,0,-Ur.y,Ur.x,0];return!tf(t,Do,Fo,Uo,Sc)||(t=[1,0,0,0,1,0,0,0,1],!tf(t,Do,Fo,Uo,Sc))?!1:(wc.crossVectors(Js,js),t=[wc.x,wc.y,wc.z],tf(t,Do,Fo,Uo,Sc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ki).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ki).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(As[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),As[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),As[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),As[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),As[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),As[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),As[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),As[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(As),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},As=[new z,new z,new z,new z,new z,new z,new z,new z],Ki=new z,Mc=new sr,Do=new z,Fo=new z,Uo=new z,Js=new z,js=new z,Ur=new z,Ia=new z,Sc=new z,wc=new z,Or=new z;function tf(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Or.fromArray(n,r);let a=s.x*Math.abs(Or.x)+s.y*Math.abs(Or.y)+s.z*Math.abs(Or.z),l=e.dot(Or),c=t.dot(Or),u=i.dot(Or);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var yn=new z,Tc=new je,tS=0,Tn=class extends Qi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:tS++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=gf,this.updateRanges=[],this.gpuType=Pi,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Tc.fromBufferAttribute(this,t),Tc.applyMatrix3(e),this.setXY(t,Tc.x,Tc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)yn.fromBufferAttribute(this,t),yn.applyMatrix3(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)yn.fromBufferAttribute(this,t),yn.applyMatrix4(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)yn.fromBufferAttribute(this,t),yn.applyNormalMatrix(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)yn.fromBufferAttribute(this,t),yn.transformDirection(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=Vo(i,this.array)),i}setComponent(e,t,i){return this.normalized&&(i=ri(i,this.array)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=Vo(t,this.array)),t}setX(e,t){return this.normalized&&(t=ri(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=Vo(t,this.array)),t}setY(e,t){return this.normalized&&(t=ri(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=Vo(t,this.array)),t}setZ(e,t){return this.normalized&&(t=ri(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=Vo(t,this.array)),t}setW(e,t){return this.normalized&&(t=ri(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=ri(t,this.array),i=ri(i,this.array)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=ri(t,this.array),i=ri(i,this.array),s=ri(s,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=ri(t,this.array),i=ri(i,this.array),s=ri(s,this.array),r=ri(r,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==gf&&(e.usage=this.usage),e}dispose(){this.dispatchEvent({type:"dispose"})}};var Xa=class extends Tn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var qa=class extends Tn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Ft=class extends Tn{constructor(e,t,i){super(new Float32Array(e),t,i)}},nS=new sr,La=new z,nf=new z,rr=class{constructor(e=new z,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):nS.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;La.subVectors(e,this.center);let t=La.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(La,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(nf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(La.copy(e.center).add(nf)),this.expandByPoint(La.copy(e.center).sub(nf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},iS=0,Oi=new Vt,sf=new hi,Oo=new z,wi=new sr,Na=new sr,Dn=new z,cn=class n extends Qi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:iS++}),this.uuid=jo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(AM(e)?qa:Xa)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new it().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Oi.makeRotationFromQuaternion(e),this.applyMatrix4(Oi),this}rotateX(e){return Oi.makeRotationX(e),this.applyMatrix4(Oi),this}rotateY(e){return Oi.makeRotationY(e),this.applyMatrix4(Oi),this}rotateZ(e){return Oi.makeRotationZ(e),this.applyMatrix4(Oi),this}translate(e,t,i){return Oi.makeTranslation(e,t,i),this.applyMatrix4(Oi),this}scale(e,t,i){return Oi.makeScale(e,t,i),this.applyMatrix4(Oi),this}lookAt(e){return sf.lookAt(e),sf.updateMatrix(),this.applyMatrix4(sf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Oo).negate(),this.translate(Oo.x,Oo.y,Oo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ft(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&$e("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new sr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Je("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new z(-1/0,-1/0,-1/0),new z(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];wi.setFromBufferAttribute(r),this.morphTargetsRelative?(Dn.addVectors(this.boundingBox.min,wi.min),this.boundingBox.expandByPoint(Dn),Dn.addVectors(this.boundingBox.max,wi.max),this.boundingBox.expandByPoint(Dn)):(this.boundingBox.expandByPoint(wi.min),this.boundingBox.expandByPoint(wi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Je('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new rr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Je("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new z,1/0);return}if(e){let i=this.boundingSphere.center;if(wi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Na.setFromBufferAttribute(a),this.morphTargetsRelative?(Dn.addVectors(wi.min,Na.min),wi.expandByPoint(Dn),Dn.addVectors(wi.max,Na.max),wi.expandByPoint(Dn)):(wi.expandByPoint(Na.min),wi.expandByPoint(Na.max))}wi.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Dn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Dn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Dn.fromBufferAttribute(a,c),l&&(Oo.fromBufferAttribute(e,c),Dn.add(Oo)),s=Math.max(s,i.distanceToSquared(Dn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Je('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Je("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Tn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[];for(let v=0;v<i.count;v++)a[v]=new z,l[v]=new z;let c=new z,u=new z,h=new z,d=new je,f=new je,p=new je,_=new z,g=new z;function m(v,E,F){c.fromBufferAttribute(i,v),u.fromBufferAttribute(i,E),h.fromBufferAttribute(i,F),d.fromBufferAttribute(r,v),f.fromBufferAttribute(r,E),p.fromBufferAttribute(r,F),u.sub(c),h.sub(c),f.sub(d),p.sub(d);let I=1/(f.x*p.y-p.x*f.y);isFinite(I)&&(_.copy(u).multiplyScalar(p.y).addScaledVector(h,-f.y).multiplyScalar(I),g.copy(h).multiplyScalar(f.x).addScaledVector(u,-p.x).multiplyScalar(I),a[v].add(_),a[E].add(_),a[F].add(_),l[v].add(g),l[E].add(g),l[F].add(g))}let S=this.groups;S.length===0&&(S=[{start:0,count:e.count}]);for(let v=0,E=S.length;v<E;++v){let F=S[v],I=F.start,U=F.count;for(let k=I,X=I+U;k<X;k+=3)m(e.getX(k+0),e.getX(k+1),e.getX(k+2))}let C=new z,b=new z,R=new z,T=new z;function N(v){R.fromBufferAttribute(s,v),T.copy(R);let E=a[v];C.copy(E),C.sub(R.multiplyScalar(R.dot(E))).normalize(),b.crossVectors(T,E);let I=b.dot(l[v])<0?-1:1;o.setXYZW(v,C.x,C.y,C.z,I)}for(let v=0,E=S.length;v<E;++v){let F=S[v],I=F.start,U=F.count;for(let k=I,X=I+U;k<X;k+=3)N(e.getX(k+0)),N(e.getX(k+1)),N(e.getX(k+2))}this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Tn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new z,r=new z,o=new z,a=new z,l=new z,c=new z,u=new z,h=new z;if(e)for(let d=0,f=e.count;d<f;d+=3){let p=e.getX(d+0),_=e.getX(d+1),g=e.getX(d+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,_),o.fromBufferAttribute(t,g),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Dn.fromBufferAttribute(e,t),Dn.normalize(),e.setXYZ(t,Dn.x,Dn.y,Dn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,p=0;for(let _=0,g=l.length;_<g;_++){a.isInterleavedBufferAttribute?f=l[_]*a.data.stride+a.offset:f=l[_]*u;for(let m=0;m<u;m++)d[p++]=c[f++]}return new Tn(d,u,h)}if(this.index===null)return $e("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=e(d,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var sS=0,Ps=class extends Qi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:sS++}),this.uuid=jo(),this.name="",this.type="Material",this.blending=Gr,this.side=ji,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Wc,this.blendDst=Xc,this.blendEquation=nr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new pt(0,0,0),this.blendAlpha=0,this.depthFunc=Hr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=mf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Vr,this.stencilZFail=Vr,this.stencilZPass=Vr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){$e(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==Gr&&(i.blending=this.blending),this.side!==ji&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==Wc&&(i.blendSrc=this.blendSrc),this.blendDst!==Xc&&(i.blendDst=this.blendDst),this.blendEquation!==nr&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==Hr&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==mf&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Vr&&(i.stencilFail=this.stencilFail),this.stencilZFail!==Vr&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==Vr&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.allowOverride===!1&&(i.allowOverride=!1),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new pt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessRange=e.iridescenceThicknessRange),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new je().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new je().fromArray(e.clearcoatNormalScale)),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Cs=new z,rf=new z,Ec=new z,Qs=new z,of=new z,Ac=new z,af=new z,or=class{constructor(e=new z,t=new z(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Cs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Cs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Cs.copy(this.origin).addScaledVector(this.direction,t),Cs.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){rf.copy(e).add(t).multiplyScalar(.5),Ec.copy(t).sub(e).normalize(),Qs.copy(this.origin).sub(rf);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Ec),a=Qs.dot(this.direction),l=-Qs.dot(Ec),c=Qs.lengthSq(),u=Math.abs(1-o*o),h,d,f,p;if(u>0)if(h=o*l-a,d=o*a-l,p=r*u,h>=0)if(d>=-p)if(d<=p){let _=1/u;h*=_,d*=_,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-p?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=p?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(rf).addScaledVector(Ec,d),f}intersectSphere(e,t){Cs.subVectors(e.center,this.origin);let i=Cs.dot(this.direction),s=Cs.dot(Cs)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Cs)!==null}intersectTriangle(e,t,i,s,r){of.subVectors(t,e),Ac.subVectors(i,e),af.crossVectors(of,Ac);let o=this.direction.dot(af),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;Qs.subVectors(this.origin,e);let l=a*this.direction.dot(Ac.crossVectors(Qs,Ac));if(l<0)return null;let c=a*this.direction.dot(of.cross(Qs));if(c<0||l+c>o)return null;let u=-a*Qs.dot(af);return u<0?null:this.at(u/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},$a=class extends Ps{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new pt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ir,this.combine=wf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},P0=new Vt,kr=new or,Cc=new rr,I0=new z,Rc=new z,Pc=new z,Ic=new z,lf=new z,Lc=new z,L0=new z,Nc=new z,wt=class extends hi{constructor(e=new cn,t=new $a){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Lc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(lf.fromBufferAttribute(h,e),o?Lc.addScaledVector(lf,u):Lc.addScaledVector(lf.sub(t),u))}t.add(Lc)}return t}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Cc.copy(i.boundingSphere),Cc.applyMatrix4(r),kr.copy(e.ray).recast(e.near),!(Cc.containsPoint(kr.origin)===!1&&(kr.intersectSphere(Cc,I0)===null||kr.origin.distanceToSquared(I0)>(e.far-e.near)**2))&&(P0.copy(r).invert(),kr.copy(e.ray).applyMatrix4(P0),!(i.boundingBox!==null&&kr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,kr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,_=d.length;p<_;p++){let g=d[p],m=o[g.materialIndex],S=Math.max(g.start,f.start),C=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let b=S,R=C;b<R;b+=3){let T=a.getX(b),N=a.getX(b+1),v=a.getX(b+2);s=Dc(this,m,e,i,c,u,h,T,N,v),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(a.count,f.start+f.count);for(let g=p,m=_;g<m;g+=3){let S=a.getX(g),C=a.getX(g+1),b=a.getX(g+2);s=Dc(this,o,e,i,c,u,h,S,C,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,_=d.length;p<_;p++){let g=d[p],m=o[g.materialIndex],S=Math.max(g.start,f.start),C=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let b=S,R=C;b<R;b+=3){let T=b,N=b+1,v=b+2;s=Dc(this,m,e,i,c,u,h,T,N,v),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(l.count,f.start+f.count);for(let g=p,m=_;g<m;g+=3){let S=g,C=g+1,b=g+2;s=Dc(this,o,e,i,c,u,h,S,C,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function rS(n,e,t,i,s,r,o,a){let l;if(e.side===oi?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===ji,a),l===null)return null;Nc.copy(a),Nc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Nc);return c<t.near||c>t.far?null:{distance:c,point:Nc.clone(),object:n}}function Dc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Rc),n.getVertexPosition(l,Pc),n.getVertexPosition(c,Ic);let u=rS(n,e,t,i,Rc,Pc,Ic,L0);if(u){let h=new z;tr.getBarycoord(L0,Rc,Pc,Ic,h),s&&(u.uv=tr.getInterpolatedAttribute(s,a,l,c,h,new je)),r&&(u.uv1=tr.getInterpolatedAttribute(r,a,l,c,h,new je)),o&&(u.normal=tr.getInterpolatedAttribute(o,a,l,c,h,new z),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new z,materialIndex:0};tr.getNormal(Rc,Pc,Ic,d.normal),u.face=d,u.barycoord=h}return u}var Wr=class extends ui{constructor(e=null,t=1,i=1,s,r,o,a,l,c=vn,u=vn,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ya=class extends Tn{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var cf=new z,oS=new z,aS=new it,ki=class{constructor(e=new z(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=cf.subVectors(i,t).cross(oS.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(cf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||aS.getNormalMatrix(e),s=this.coplanarPoint(cf).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}},Br=new rr,lS=new je(.5,.5),Fc=new z,Za=class{constructor(e=new ki,t=new ki,i=new ki,s=new ki,r=new ki,o=new ki){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ji,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],p=r[8],_=r[9],g=r[10],m=r[11],S=r[12],C=r[13],b=r[14],R=r[15];if(s[0].setComponents(c-o,f-u,m-p,R-S).normalize(),s[1].setComponents(c+o,f+u,m+p,R+S).normalize(),s[2].setComponents(c+a,f+h,m+_,R+C).normalize(),s[3].setComponents(c-a,f-h,m-_,R-C).normalize(),i)s[4].setComponents(l,d,g,b).normalize(),s[5].setComponents(c-l,f-d,m-g,R-b).normalize();else if(s[4].setComponents(c-l,f-d,m-g,R-b).normalize(),t===Ji)s[5].setComponents(c+l,f+d,m+g,R+b).normalize();else if(t===Va)s[5].setComponents(l,d,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Br.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Br.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Br)}intersectsSprite(e){Br.center.set(0,0,0);let t=lS.distanceTo(e.center);return Br.radius=.7071067811865476+t,Br.applyMatrix4(e.matrixWorld),this.intersectsSphere(Br)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Fc.x=s.normal.x>0?e.max.x:e.min.x,Fc.y=s.normal.y>0?e.max.y:e.min.y,Fc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Fc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var qo=class extends Ps{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new pt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},ru=new z,ou=new z,N0=new Vt,Da=new or,Uc=new rr,uf=new z,D0=new z,$o=class extends hi{constructor(e=new cn,t=new qo){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)ru.fromBufferAttribute(t,s-1),ou.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=ru.distanceTo(ou);e.setAttribute("lineDistance",new Ft(i,1))}else $e("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Uc.copy(i.boundingSphere),Uc.applyMatrix4(s),Uc.radius+=r,e.ray.intersectsSphere(Uc)===!1)return;N0.copy(s).invert(),Da.copy(e.ray).applyMatrix4(N0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let _=f,g=p-1;_<g;_+=c){let m=u.getX(_),S=u.getX(_+1),C=Oc(this,e,Da,l,m,S,_);C&&t.push(C)}if(this.isLineLoop){let _=u.getX(p-1),g=u.getX(f),m=Oc(this,e,Da,l,_,g,p-1);m&&t.push(m)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let _=f,g=p-1;_<g;_+=c){let m=Oc(this,e,Da,l,_,_+1,_);m&&t.push(m)}if(this.isLineLoop){let _=Oc(this,e,Da,l,p-1,f,p-1);_&&t.push(_)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Oc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(ru.fromBufferAttribute(a,s),ou.fromBufferAttribute(a,r),t.distanceSqToSegment(ru,ou,uf,D0)>i)return;uf.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(uf);if(!(c<e.near||c>e.far))return{distance:c,point:D0.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var au=class extends Ps{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new pt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},F0=new Vt,_f=new or,kc=new rr,Bc=new z,Ka=class extends hi{constructor(e=new cn,t=new au){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),kc.copy(i.boundingSphere),kc.applyMatrix4(s),kc.radius+=r,e.ray.intersectsSphere(kc)===!1)return;F0.copy(s).invert(),_f.copy(e.ray).applyMatrix4(F0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let p=d,_=f;p<_;p++){let g=c.getX(p);Bc.fromBufferAttribute(h,g),U0(Bc,g,l,s,e,t,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let p=d,_=f;p<_;p++)Bc.fromBufferAttribute(h,p),U0(Bc,p,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function U0(n,e,t,i,s,r,o){let a=_f.distanceSqToPoint(n);if(a<t){let l=new z;_f.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var Ja=class extends ui{constructor(e=[],t=dr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Is=class extends ui{constructor(e,t,i=ts,s,r,o,a=vn,l=vn,c,u=hs,h=1){if(u!==hs&&u!==pr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Wo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}},lu=class extends Is{constructor(e,t=ts,i=dr,s,r,o=vn,a=vn,l,c=hs){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ja=class extends ui{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},ds=class n extends cn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Ft(c,3)),this.setAttribute("normal",new Ft(u,3)),this.setAttribute("uv",new Ft(h,2));function p(_,g,m,S,C,b,R,T,N,v,E){let F=b/N,I=R/v,U=b/2,k=R/2,X=T/2,O=N+1,$=v+1,H=0,ie=0,oe=new z;for(let le=0;le<$;le++){let de=le*I-k;for(let ue=0;ue<O;ue++){let _e=ue*F-U;oe[_]=_e*S,oe[g]=de*C,oe[m]=X,c.push(oe.x,oe.y,oe.z),oe[_]=0,oe[g]=0,oe[m]=T>0?1:-1,u.push(oe.x,oe.y,oe.z),h.push(ue/N),h.push(1-le/v),H+=1}}for(let le=0;le<v;le++)for(let de=0;de<N;de++){let ue=d+de+O*le,_e=d+de+O*(le+1),st=d+(de+1)+O*(le+1),et=d+(de+1)+O*le;l.push(ue,_e,et),l.push(_e,st,et),ie+=6}a.addGroup(f,ie,E),f+=ie,d+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Ls=class n extends cn{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],p=0,_=[],g=i/2,m=0;S(),o===!1&&(e>0&&C(!0),t>0&&C(!1)),this.setIndex(u),this.setAttribute("position",new Ft(h,3)),this.setAttribute("normal",new Ft(d,3)),this.setAttribute("uv",new Ft(f,2));function S(){let b=new z,R=new z,T=0,N=(t-e)/i;for(let v=0;v<=r;v++){let E=[],F=v/r,I=F*(t-e)+e;for(let U=0;U<=s;U++){let k=U/s,X=k*l+a,O=Math.sin(X),$=Math.cos(X);R.x=I*O,R.y=-F*i+g,R.z=I*$,h.push(R.x,R.y,R.z),b.set(O,N,$).normalize(),d.push(b.x,b.y,b.z),f.push(k,1-F),E.push(p++)}_.push(E)}for(let v=0;v<s;v++)for(let E=0;E<r;E++){let F=_[E][v],I=_[E+1][v],U=_[E+1][v+1],k=_[E][v+1];(e>0||E!==0)&&(u.push(F,I,k),T+=3),(t>0||E!==r-1)&&(u.push(I,U,k),T+=3)}c.addGroup(m,T,0),m+=T}function C(b){let R=p,T=new je,N=new z,v=0,E=b===!0?e:t,F=b===!0?1:-1;for(let U=1;U<=s;U++)h.push(0,g*F,0),d.push(0,F,0),f.push(.5,.5),p++;let I=p;for(let U=0;U<=s;U++){let X=U/s*l+a,O=Math.cos(X),$=Math.sin(X);N.x=E*$,N.y=g*F,N.z=E*O,h.push(N.x,N.y,N.z),d.push(0,F,0),T.x=O*.5+.5,T.y=$*.5*F+.5,f.push(T.x,T.y),p++}for(let U=0;U<s;U++){let k=R+U,X=I+U;b===!0?u.push(X,X+1,k):u.push(X+1,X,k),v+=3}c.addGroup(m,v,b===!0?1:2),m+=v}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Xr=class n extends cn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,d=t/l,f=[],p=[],_=[],g=[];for(let m=0;m<u;m++){let S=m*d-o;for(let C=0;C<c;C++){let b=C*h-r;p.push(b,-S,0),_.push(0,0,1),g.push(C/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let S=0;S<a;S++){let C=S+c*m,b=S+c*(m+1),R=S+1+c*(m+1),T=S+1+c*m;f.push(C,b,T),f.push(b,R,T)}this.setIndex(f),this.setAttribute("position",new Ft(p,3)),this.setAttribute("normal",new Ft(_,3)),this.setAttribute("uv",new Ft(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var Qa=class n extends cn{constructor(e=1,t=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],h=[],d=new z,f=new z,p=new z;for(let _=0;_<=i;_++){let g=o+_/i*a;for(let m=0;m<=s;m++){let S=m/s*r;f.x=(e+t*Math.cos(g))*Math.cos(S),f.y=(e+t*Math.cos(g))*Math.sin(S),f.z=t*Math.sin(g),c.push(f.x,f.y,f.z),d.x=e*Math.cos(S),d.y=e*Math.sin(S),p.subVectors(f,d).normalize(),u.push(p.x,p.y,p.z),h.push(m/s),h.push(_/i)}}for(let _=1;_<=i;_++)for(let g=1;g<=s;g++){let m=(s+1)*_+g-1,S=(s+1)*(_-1)+g-1,C=(s+1)*(_-1)+g,b=(s+1)*_+g;l.push(m,S,b),l.push(S,C,b)}this.setIndex(l),this.setAttribute("position",new Ft(c,3)),this.setAttribute("normal",new Ft(u,3)),this.setAttribute("uv",new Ft(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc)}};function $r(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(O0(s))s.isRenderTargetTexture?($e("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(O0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Yn(n){let e={};for(let t=0;t<n.length;t++){let i=$r(n[t]);for(let s in i)e[s]=i[s]}return e}function O0(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function cS(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Xf(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:xt.workingColorSpace}var S_={clone:$r,merge:Yn},uS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,hS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,en=class extends Ps{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=uS,this.fragmentShader=hS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=$r(e.uniforms),this.uniformsGroups=cS(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new pt().setHex(s.value);break;case"v2":this.uniforms[i].value=new je().fromArray(s.value);break;case"v3":this.uniforms[i].value=new z().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Qt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new it().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Vt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},cu=class extends en{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var uu=class extends Ps{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=u_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},hu=class extends Ps{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Vc(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}var ar=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},du=class extends ar{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:df,endingEnd:df}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case ff:r=e,a=2*t-i;break;case pf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case ff:o=e,l=2*i-t;break;case pf:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-t)/(s-t),_=p*p,g=_*p,m=-d*g+2*d*_-d*p,S=(1+d)*g+(-1.5-2*d)*_+(-.5+d)*p+1,C=(-1-f)*g+(1.5+f)*_+.5*p,b=f*g-f*_;for(let R=0;R!==a;++R)r[R]=m*o[u+R]+S*o[c+R]+C*o[l+R]+b*o[h+R];return r}},fu=class extends ar{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},pu=class extends ar{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},mu=class extends ar{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(i-t)/(s-t),_=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*_+o[l+g]*p;return r}let d=a*2,f=e-1;for(let p=0;p!==a;++p){let _=o[c+p],g=o[l+p],m=f*d+p*2,S=h[m],C=h[m+1],b=e*d+p*2,R=u[b],T=u[b+1],N=(i-t)/(s-t),v,E,F,I,U;for(let k=0;k<8;k++){v=N*N,E=v*N,F=1-N,I=F*F,U=I*F;let O=U*t+3*I*N*S+3*F*v*R+E*s-i;if(Math.abs(O)<1e-10)break;let $=3*I*(S-t)+6*F*N*(R-S)+3*v*(s-R);if(Math.abs($)<1e-10)break;N=N-O/$,N=Math.max(0,Math.min(1,N))}r[p]=U*_+3*I*N*C+3*F*v*T+E*g}return r}},Ci=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Vc(t,this.TimeBufferType),this.values=Vc(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Vc(e.times,Array),values:Vc(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s)}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new pu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new fu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new du(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new mu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Oa:t=this.InterpolantFactoryMethodDiscrete;break;case tu:t=this.InterpolantFactoryMethodLinear;break;case Hc:t=this.InterpolantFactoryMethodSmooth;break;case hf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return $e("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Oa;case this.InterpolantFactoryMethodLinear:return tu;case this.InterpolantFactoryMethodSmooth:return Hc;case this.InterpolantFactoryMethodBezier:return hf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Je("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Je("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Je("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Je("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&CM(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Je("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Hc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let p=0;p!==i;++p){let _=t[h+p];if(_!==t[d+p]||_!==t[f+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)t[d+f]=t[h+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,s}};Ci.prototype.ValueTypeName="";Ci.prototype.TimeBufferType=Float32Array;Ci.prototype.ValueBufferType=Float32Array;Ci.prototype.DefaultInterpolation=tu;var lr=class extends Ci{constructor(e,t,i){super(e,t,i)}};lr.prototype.ValueTypeName="bool";lr.prototype.ValueBufferType=Array;lr.prototype.DefaultInterpolation=Oa;lr.prototype.InterpolantFactoryMethodLinear=void 0;lr.prototype.InterpolantFactoryMethodSmooth=void 0;var gu=class extends Ci{constructor(e,t,i,s){super(e,t,i,s)}};gu.prototype.ValueTypeName="color";var _u=class extends Ci{constructor(e,t,i,s){super(e,t,i,s)}};_u.prototype.ValueTypeName="number";var xu=class extends ar{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)qn.slerpFlat(r,0,o,c-a,o,c,l);return r}},el=class extends Ci{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new xu(this.times,this.values,this.getValueSize(),e)}};el.prototype.ValueTypeName="quaternion";el.prototype.InterpolantFactoryMethodSmooth=void 0;var cr=class extends Ci{constructor(e,t,i){super(e,t,i)}};cr.prototype.ValueTypeName="string";cr.prototype.ValueBufferType=Array;cr.prototype.DefaultInterpolation=Oa;cr.prototype.InterpolantFactoryMethodLinear=void 0;cr.prototype.InterpolantFactoryMethodSmooth=void 0;var yu=class extends Ci{constructor(e,t,i,s){super(e,t,i,s)}};yu.prototype.ValueTypeName="vector";var vu=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],p=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},w_=new vu,bu=class{constructor(e){this.manager=e!==void 0?e:w_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}abort(){return this}};bu.DEFAULT_MATERIAL_NAME="__DEFAULT";var zc=new z,Gc=new qn,cs=new z,tl=class extends hi{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Vt,this.projectionMatrix=new Vt,this.projectionMatrixInverse=new Vt,this.coordinateSystem=Ji,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(zc,Gc,cs),cs.x===1&&cs.y===1&&cs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(zc,Gc,cs.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(zc,Gc,cs),cs.x===1&&cs.y===1&&cs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(zc,Gc,cs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},er=new z,k0=new je,B0=new je,Xn=class extends tl{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Ho*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Fa*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Ho*2*Math.atan(Math.tan(Fa*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){er.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(er.x,er.y).multiplyScalar(-e/er.z),er.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(er.x,er.y).multiplyScalar(-e/er.z)}getViewSize(e,t){return this.getViewBounds(e,k0,B0),t.subVectors(B0,k0)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Fa*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var nl=class extends tl{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var il=class extends cn{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var ko=-90,Bo=1,Mu=class extends hi{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Xn(ko,Bo,e,t);s.layers=this.layers,this.add(s);let r=new Xn(ko,Bo,e,t);r.layers=this.layers,this.add(r);let o=new Xn(ko,Bo,e,t);o.layers=this.layers,this.add(o);let a=new Xn(ko,Bo,e,t);a.layers=this.layers,this.add(a);let l=new Xn(ko,Bo,e,t);l.layers=this.layers,this.add(l);let c=new Xn(ko,Bo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ji)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Va)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let _=i.texture.generateMipmaps;i.texture.generateMipmaps=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.generateMipmaps=_,e.setRenderTarget(i,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},Su=class extends Xn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}};var qf="\\[\\]\\.:\\/",dS=new RegExp("["+qf+"]","g"),$f="[^"+qf+"]",fS="[^"+qf.replace("\\.","")+"]",pS=/((?:WC+[\/:])*)/.source.replace("WC",$f),mS=/(WCOD+)?/.source.replace("WCOD",fS),gS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",$f),_S=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",$f),xS=new RegExp("^"+pS+mS+gS+_S+"$"),yS=["material","materials","bones","map"],xf=class{constructor(e,t,i){let s=i||jt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},jt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(dS,"")}static parseTrackName(e){let t=xS.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);yS.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){$e("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){Je("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Je("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Je("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Je("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Je("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){Je("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){Je("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Je("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Je("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Je("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};jt.Composite=xf;jt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};jt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};jt.prototype.GetterByBindingType=[jt.prototype._getValue_direct,jt.prototype._getValue_array,jt.prototype._getValue_arrayElement,jt.prototype._getValue_toArray];jt.prototype.SetterByBindingTypeAndVersioning=[[jt.prototype._setValue_direct,jt.prototype._setValue_direct_setNeedsUpdate,jt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_array,jt.prototype._setValue_array_setNeedsUpdate,jt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_arrayElement,jt.prototype._setValue_arrayElement_setNeedsUpdate,jt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_fromArray,jt.prototype._setValue_fromArray_setNeedsUpdate,jt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var B3=new Float32Array(1);var Yo=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ut(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(ut(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var yf=class n{static{n.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var sl=class extends Qi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){if(e===void 0){$e("Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Yf(n,e,t,i){let s=vS(i);switch(t){case Of:return n*e;case Bf:return n*e/s.components*s.byteLength;case Pu:return n*e/s.components*s.byteLength;case mr:return n*e*2/s.components*s.byteLength;case Iu:return n*e*2/s.components*s.byteLength;case kf:return n*e*3/s.components*s.byteLength;case ai:return n*e*4/s.components*s.byteLength;case Lu:return n*e*4/s.components*s.byteLength;case ll:case cl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case ul:case hl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Du:case Uu:return Math.max(n,16)*Math.max(e,8)/4;case Nu:case Fu:return Math.max(n,8)*Math.max(e,8)/2;case Ou:case ku:case Vu:case zu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Bu:case dl:case Gu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Hu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Wu:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Xu:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case qu:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case $u:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Yu:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Zu:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Ku:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Ju:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case ju:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Qu:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case eh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case th:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case nh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case ih:case sh:case rh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case oh:case ah:return Math.ceil(n/4)*Math.ceil(e/4)*8;case fl:case lh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function vS(n){switch(n){case Ri:case Nf:return{byteLength:1,components:1};case Ko:case Df:case ps:return{byteLength:2,components:1};case Cu:case Ru:return{byteLength:2,components:4};case ts:case Au:case Pi:return{byteLength:4,components:1};case Ff:case Uf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"185"}}));typeof window<"u"&&(window.__THREE__?$e("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="185");function $_(){let n=null,e=!1,t=null,i=null;function s(r,o){t(r,o),i=n.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function MS(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<h.length;f++){let p=h[d],_=h[f];_.start<=p.start+p.count+1?p.count=Math.max(p.count,_.start+_.count-p.start):(++d,h[d]=_)}h.length=d+1;for(let f=0,p=h.length;f<p;f++){let _=h[f];n.bufferSubData(c,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var SS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,wS=`#ifdef USE_ALPHAHASH
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
#endif`,TS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,ES=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,AS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,CS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,RS=`#ifdef USE_AOMAP
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
#endif`,PS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,IS=`#ifdef USE_BATCHING
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
#endif`,LS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,NS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,DS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,FS=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,US=`#ifdef USE_IRIDESCENCE
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
#endif`,OS=`#ifdef USE_BUMPMAP
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
#endif`,kS=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,BS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,VS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,zS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,GS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,HS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,WS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,XS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,qS=`#define PI 3.141592653589793
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
} // validated`,$S=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,YS=`vec3 transformedNormal = objectNormal;
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
#endif`,ZS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,KS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,JS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,jS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,QS="gl_FragColor = linearToOutputTexel( gl_FragColor );",ew=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,tw=`#ifdef USE_ENVMAP
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
#endif`,nw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
#endif`,iw=`#ifdef USE_ENVMAP
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
#endif`,sw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,rw=`#ifdef USE_ENVMAP
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
#endif`,ow=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,aw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,lw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,cw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,uw=`#ifdef USE_GRADIENTMAP
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
}`,hw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,dw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,fw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,pw=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,mw=`#ifdef USE_ENVMAP
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
#endif`,gw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,_w=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,xw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,yw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,vw=`PhysicalMaterial material;
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
#endif`,bw=`uniform sampler2D dfgLUT;
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
}`,Mw=`
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
#endif`,Sw=`#if defined( RE_IndirectDiffuse )
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
#endif`,ww=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Tw=`#ifdef USE_LIGHT_PROBES_GRID
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
#endif`,Ew=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Aw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Cw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Rw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Pw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Iw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Lw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Nw=`#if defined( USE_POINTS_UV )
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
#endif`,Dw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Fw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Uw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Ow=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,kw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Bw=`#ifdef USE_MORPHTARGETS
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
#endif`,Vw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,zw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Gw=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Hw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Ww=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Xw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,qw=`#ifdef USE_NORMALMAP
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
#endif`,$w=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Yw=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Zw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Kw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Jw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,jw=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Qw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,e1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,t1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,n1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,i1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,s1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,r1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,o1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,a1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,l1=`float getShadowMask() {
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
}`,c1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,u1=`#ifdef USE_SKINNING
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
#endif`,h1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,d1=`#ifdef USE_SKINNING
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
#endif`,f1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,p1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,m1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,g1=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,_1=`#ifdef USE_TRANSMISSION
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
#endif`,x1=`#ifdef USE_TRANSMISSION
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
#endif`,y1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,v1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,b1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,M1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,S1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,w1=`uniform sampler2D t2D;
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
}`,T1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,E1=`#ifdef ENVMAP_TYPE_CUBE
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
}`,A1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,C1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,R1=`#include <common>
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
}`,P1=`#if DEPTH_PACKING == 3200
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
}`,I1=`#define DISTANCE
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
}`,L1=`#define DISTANCE
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
}`,N1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,D1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,F1=`uniform float scale;
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
}`,U1=`uniform vec3 diffuse;
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
}`,O1=`#include <common>
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
}`,k1=`uniform vec3 diffuse;
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
}`,B1=`#define LAMBERT
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
}`,V1=`#define LAMBERT
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
}`,z1=`#define MATCAP
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
}`,G1=`#define MATCAP
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
}`,H1=`#define NORMAL
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
}`,W1=`#define NORMAL
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
}`,X1=`#define PHONG
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
}`,q1=`#define PHONG
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
}`,$1=`#define STANDARD
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
}`,Y1=`#define STANDARD
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
}`,Z1=`#define TOON
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
}`,K1=`#define TOON
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
}`,J1=`uniform float size;
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
}`,j1=`uniform vec3 diffuse;
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
}`,Q1=`#include <common>
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
}`,eT=`uniform vec3 color;
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
}`,tT=`uniform float rotation;
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
}`,nT=`uniform vec3 diffuse;
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
}`,at={alphahash_fragment:SS,alphahash_pars_fragment:wS,alphamap_fragment:TS,alphamap_pars_fragment:ES,alphatest_fragment:AS,alphatest_pars_fragment:CS,aomap_fragment:RS,aomap_pars_fragment:PS,batching_pars_vertex:IS,batching_vertex:LS,begin_vertex:NS,beginnormal_vertex:DS,bsdfs:FS,iridescence_fragment:US,bumpmap_pars_fragment:OS,clipping_planes_fragment:kS,clipping_planes_pars_fragment:BS,clipping_planes_pars_vertex:VS,clipping_planes_vertex:zS,color_fragment:GS,color_pars_fragment:HS,color_pars_vertex:WS,color_vertex:XS,common:qS,cube_uv_reflection_fragment:$S,defaultnormal_vertex:YS,displacementmap_pars_vertex:ZS,displacementmap_vertex:KS,emissivemap_fragment:JS,emissivemap_pars_fragment:jS,colorspace_fragment:QS,colorspace_pars_fragment:ew,envmap_fragment:tw,envmap_common_pars_fragment:nw,envmap_pars_fragment:iw,envmap_pars_vertex:sw,envmap_physical_pars_fragment:mw,envmap_vertex:rw,fog_vertex:ow,fog_pars_vertex:aw,fog_fragment:lw,fog_pars_fragment:cw,gradientmap_pars_fragment:uw,lightmap_pars_fragment:hw,lights_lambert_fragment:dw,lights_lambert_pars_fragment:fw,lights_pars_begin:pw,lights_toon_fragment:gw,lights_toon_pars_fragment:_w,lights_phong_fragment:xw,lights_phong_pars_fragment:yw,lights_physical_fragment:vw,lights_physical_pars_fragment:bw,lights_fragment_begin:Mw,lights_fragment_maps:Sw,lights_fragment_end:ww,lightprobes_pars_fragment:Tw,logdepthbuf_fragment:Ew,logdepthbuf_pars_fragment:Aw,logdepthbuf_pars_vertex:Cw,logdepthbuf_vertex:Rw,map_fragment:Pw,map_pars_fragment:Iw,map_particle_fragment:Lw,map_particle_pars_fragment:Nw,metalnessmap_fragment:Dw,metalnessmap_pars_fragment:Fw,morphinstance_vertex:Uw,morphcolor_vertex:Ow,morphnormal_vertex:kw,morphtarget_pars_vertex:Bw,morphtarget_vertex:Vw,normal_fragment_begin:zw,normal_fragment_maps:Gw,normal_pars_fragment:Hw,normal_pars_vertex:Ww,normal_vertex:Xw,normalmap_pars_fragment:qw,clearcoat_normal_fragment_begin:$w,clearcoat_normal_fragment_maps:Yw,clearcoat_pars_fragment:Zw,iridescence_pars_fragment:Kw,opaque_fragment:Jw,packing:jw,premultiplied_alpha_fragment:Qw,project_vertex:e1,dithering_fragment:t1,dithering_pars_fragment:n1,roughnessmap_fragment:i1,roughnessmap_pars_fragment:s1,shadowmap_pars_fragment:r1,shadowmap_pars_vertex:o1,shadowmap_vertex:a1,shadowmask_pars_fragment:l1,skinbase_vertex:c1,skinning_pars_vertex:u1,skinning_vertex:h1,skinnormal_vertex:d1,specularmap_fragment:f1,specularmap_pars_fragment:p1,tonemapping_fragment:m1,tonemapping_pars_fragment:g1,transmission_fragment:_1,transmission_pars_fragment:x1,uv_pars_fragment:y1,uv_pars_vertex:v1,uv_vertex:b1,worldpos_vertex:M1,background_vert:S1,background_frag:w1,backgroundCube_vert:T1,backgroundCube_frag:E1,cube_vert:A1,cube_frag:C1,depth_vert:R1,depth_frag:P1,distance_vert:I1,distance_frag:L1,equirect_vert:N1,equirect_frag:D1,linedashed_vert:F1,linedashed_frag:U1,meshbasic_vert:O1,meshbasic_frag:k1,meshlambert_vert:B1,meshlambert_frag:V1,meshmatcap_vert:z1,meshmatcap_frag:G1,meshnormal_vert:H1,meshnormal_frag:W1,meshphong_vert:X1,meshphong_frag:q1,meshphysical_vert:$1,meshphysical_frag:Y1,meshtoon_vert:Z1,meshtoon_frag:K1,points_vert:J1,points_frag:j1,shadow_vert:Q1,shadow_frag:eT,sprite_vert:tT,sprite_frag:nT},Ee={common:{diffuse:{value:new pt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new it}},envmap:{envMap:{value:null},envMapRotation:{value:new it},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new it}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new it}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new it},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new it},normalScale:{value:new je(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new it},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new it}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new it}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new it}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new pt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:null},probesMin:{value:new z},probesMax:{value:new z},probesResolution:{value:new z}},points:{diffuse:{value:new pt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0},uvTransform:{value:new it}},sprite:{diffuse:{value:new pt(16777215)},opacity:{value:1},center:{value:new je(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}}},gs={basic:{uniforms:Yn([Ee.common,Ee.specularmap,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.fog]),vertexShader:at.meshbasic_vert,fragmentShader:at.meshbasic_frag},lambert:{uniforms:Yn([Ee.common,Ee.specularmap,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.fog,Ee.lights,{emissive:{value:new pt(0)},envMapIntensity:{value:1}}]),vertexShader:at.meshlambert_vert,fragmentShader:at.meshlambert_frag},phong:{uniforms:Yn([Ee.common,Ee.specularmap,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.fog,Ee.lights,{emissive:{value:new pt(0)},specular:{value:new pt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:at.meshphong_vert,fragmentShader:at.meshphong_frag},standard:{uniforms:Yn([Ee.common,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.roughnessmap,Ee.metalnessmap,Ee.fog,Ee.lights,{emissive:{value:new pt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag},toon:{uniforms:Yn([Ee.common,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.gradientmap,Ee.fog,Ee.lights,{emissive:{value:new pt(0)}}]),vertexShader:at.meshtoon_vert,fragmentShader:at.meshtoon_frag},matcap:{uniforms:Yn([Ee.common,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.fog,{matcap:{value:null}}]),vertexShader:at.meshmatcap_vert,fragmentShader:at.meshmatcap_frag},points:{uniforms:Yn([Ee.points,Ee.fog]),vertexShader:at.points_vert,fragmentShader:at.points_frag},dashed:{uniforms:Yn([Ee.common,Ee.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:at.linedashed_vert,fragmentShader:at.linedashed_frag},depth:{uniforms:Yn([Ee.common,Ee.displacementmap]),vertexShader:at.depth_vert,fragmentShader:at.depth_frag},normal:{uniforms:Yn([Ee.common,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,{opacity:{value:1}}]),vertexShader:at.meshnormal_vert,fragmentShader:at.meshnormal_frag},sprite:{uniforms:Yn([Ee.sprite,Ee.fog]),vertexShader:at.sprite_vert,fragmentShader:at.sprite_frag},background:{uniforms:{uvTransform:{value:new it},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:at.background_vert,fragmentShader:at.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new it}},vertexShader:at.backgroundCube_vert,fragmentShader:at.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:at.cube_vert,fragmentShader:at.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:at.equirect_vert,fragmentShader:at.equirect_frag},distance:{uniforms:Yn([Ee.common,Ee.displacementmap,{referencePosition:{value:new z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:at.distance_vert,fragmentShader:at.distance_frag},shadow:{uniforms:Yn([Ee.lights,Ee.fog,{color:{value:new pt(0)},opacity:{value:1}}]),vertexShader:at.shadow_vert,fragmentShader:at.shadow_frag}};gs.physical={uniforms:Yn([gs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new it},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new it},clearcoatNormalScale:{value:new je(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new it},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new it},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new it},sheen:{value:0},sheenColor:{value:new pt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new it},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new it},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new it},transmissionSamplerSize:{value:new je},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new it},attenuationDistance:{value:0},attenuationColor:{value:new pt(0)},specularColor:{value:new pt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new it},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new it},anisotropyVector:{value:new je},anisotropyMap:{value:null},anisotropyMapTransform:{value:new it}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag};var hh={r:0,b:0,g:0},iT=new Vt,Y_=new it;Y_.set(-1,0,0,0,1,0,0,0,1);function sT(n,e,t,i,s,r){let o=new pt(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(S){let C=S.isScene===!0?S.background:null;if(C&&C.isTexture){let b=S.backgroundBlurriness>0;C=e.get(C,b)}return C}function p(S){let C=!1,b=f(S);b===null?g(o,a):b&&b.isColor&&(g(b,1),C=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||C)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(S,C){let b=f(C);b&&(b.isCubeTexture||b.mapping===ol)?(c===void 0&&(c=new wt(new ds(1,1,1),new en({name:"BackgroundCubeMaterial",uniforms:$r(gs.backgroundCube.uniforms),vertexShader:gs.backgroundCube.vertexShader,fragmentShader:gs.backgroundCube.fragmentShader,side:oi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,T,N){this.matrixWorld.copyPosition(N.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(iT.makeRotationFromEuler(C.backgroundRotation)).transpose(),b.isCubeTexture&&b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Y_),c.material.toneMapped=xt.getTransfer(b.colorSpace)!==Dt,(u!==b||h!==b.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,h=b.version,d=n.toneMapping),c.layers.enableAll(),S.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new wt(new Xr(2,2),new en({name:"BackgroundMaterial",uniforms:$r(gs.background.uniforms),vertexShader:gs.background.vertexShader,fragmentShader:gs.background.fragmentShader,side:ji,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=xt.getTransfer(b.colorSpace)!==Dt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||h!==b.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,h=b.version,d=n.toneMapping),l.layers.enableAll(),S.unshift(l,l.geometry,l.material,0,0,null))}function g(S,C){S.getRGB(hh,Xf(n)),t.buffers.color.setClear(hh.r,hh.g,hh.b,C,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(S,C=1){o.set(S),a=C,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(S){a=S,g(o,a)},render:p,addToRenderList:_,dispose:m}}function rT(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(I,U,k,X,O){let $=!1,H=h(I,X,k,U);r!==H&&(r=H,c(r.object)),$=f(I,X,k,O),$&&p(I,X,k,O),O!==null&&e.update(O,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,b(I,U,k,X),O!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(O).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function u(I){return n.deleteVertexArray(I)}function h(I,U,k,X){let O=X.wireframe===!0,$=i[U.id];$===void 0&&($={},i[U.id]=$);let H=I.isInstancedMesh===!0?I.id:0,ie=$[H];ie===void 0&&(ie={},$[H]=ie);let oe=ie[k.id];oe===void 0&&(oe={},ie[k.id]=oe);let le=oe[O];return le===void 0&&(le=d(l()),oe[O]=le),le}function d(I){let U=[],k=[],X=[];for(let O=0;O<t;O++)U[O]=0,k[O]=0,X[O]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:U,enabledAttributes:k,attributeDivisors:X,object:I,attributes:{},index:null}}function f(I,U,k,X){let O=r.attributes,$=U.attributes,H=0,ie=k.getAttributes();for(let oe in ie)if(ie[oe].location>=0){let de=O[oe],ue=$[oe];if(ue===void 0&&(oe==="instanceMatrix"&&I.instanceMatrix&&(ue=I.instanceMatrix),oe==="instanceColor"&&I.instanceColor&&(ue=I.instanceColor)),de===void 0||de.attribute!==ue||ue&&de.data!==ue.data)return!0;H++}return r.attributesNum!==H||r.index!==X}function p(I,U,k,X){let O={},$=U.attributes,H=0,ie=k.getAttributes();for(let oe in ie)if(ie[oe].location>=0){let de=$[oe];de===void 0&&(oe==="instanceMatrix"&&I.instanceMatrix&&(de=I.instanceMatrix),oe==="instanceColor"&&I.instanceColor&&(de=I.instanceColor));let ue={};ue.attribute=de,de&&de.data&&(ue.data=de.data),O[oe]=ue,H++}r.attributes=O,r.attributesNum=H,r.index=X}function _(){let I=r.newAttributes;for(let U=0,k=I.length;U<k;U++)I[U]=0}function g(I){m(I,0)}function m(I,U){let k=r.newAttributes,X=r.enabledAttributes,O=r.attributeDivisors;k[I]=1,X[I]===0&&(n.enableVertexAttribArray(I),X[I]=1),O[I]!==U&&(n.vertexAttribDivisor(I,U),O[I]=U)}function S(){let I=r.newAttributes,U=r.enabledAttributes;for(let k=0,X=U.length;k<X;k++)U[k]!==I[k]&&(n.disableVertexAttribArray(k),U[k]=0)}function C(I,U,k,X,O,$,H){H===!0?n.vertexAttribIPointer(I,U,k,O,$):n.vertexAttribPointer(I,U,k,X,O,$)}function b(I,U,k,X){_();let O=X.attributes,$=k.getAttributes(),H=U.defaultAttributeValues;for(let ie in $){let oe=$[ie];if(oe.location>=0){let le=O[ie];if(le===void 0&&(ie==="instanceMatrix"&&I.instanceMatrix&&(le=I.instanceMatrix),ie==="instanceColor"&&I.instanceColor&&(le=I.instanceColor)),le!==void 0){let de=le.normalized,ue=le.itemSize,_e=e.get(le);if(_e===void 0)continue;let st=_e.buffer,et=_e.type,Q=_e.bytesPerElement,ae=et===n.INT||et===n.UNSIGNED_INT||le.gpuType===Au;if(le.isInterleavedBufferAttribute){let he=le.data,Ve=he.stride,De=le.offset;if(he.isInstancedInterleavedBuffer){for(let ke=0;ke<oe.locationSize;ke++)m(oe.location+ke,he.meshPerAttribute);I.isInstancedMesh!==!0&&X._maxInstanceCount===void 0&&(X._maxInstanceCount=he.meshPerAttribute*he.count)}else for(let ke=0;ke<oe.locationSize;ke++)g(oe.location+ke);n.bindBuffer(n.ARRAY_BUFFER,st);for(let ke=0;ke<oe.locationSize;ke++)C(oe.location+ke,ue/oe.locationSize,et,de,Ve*Q,(De+ue/oe.locationSize*ke)*Q,ae)}else{if(le.isInstancedBufferAttribute){for(let he=0;he<oe.locationSize;he++)m(oe.location+he,le.meshPerAttribute);I.isInstancedMesh!==!0&&X._maxInstanceCount===void 0&&(X._maxInstanceCount=le.meshPerAttribute*le.count)}else for(let he=0;he<oe.locationSize;he++)g(oe.location+he);n.bindBuffer(n.ARRAY_BUFFER,st);for(let he=0;he<oe.locationSize;he++)C(oe.location+he,ue/oe.locationSize,et,de,ue*Q,ue/oe.locationSize*he*Q,ae)}}else if(H!==void 0){let de=H[ie];if(de!==void 0)switch(de.length){case 2:n.vertexAttrib2fv(oe.location,de);break;case 3:n.vertexAttrib3fv(oe.location,de);break;case 4:n.vertexAttrib4fv(oe.location,de);break;default:n.vertexAttrib1fv(oe.location,de)}}}}S()}function R(){E();for(let I in i){let U=i[I];for(let k in U){let X=U[k];for(let O in X){let $=X[O];for(let H in $)u($[H].object),delete $[H];delete X[O]}}delete i[I]}}function T(I){if(i[I.id]===void 0)return;let U=i[I.id];for(let k in U){let X=U[k];for(let O in X){let $=X[O];for(let H in $)u($[H].object),delete $[H];delete X[O]}}delete i[I.id]}function N(I){for(let U in i){let k=i[U];for(let X in k){let O=k[X];if(O[I.id]===void 0)continue;let $=O[I.id];for(let H in $)u($[H].object),delete $[H];delete O[I.id]}}}function v(I){for(let U in i){let k=i[U],X=I.isInstancedMesh===!0?I.id:0,O=k[X];if(O!==void 0){for(let $ in O){let H=O[$];for(let ie in H)u(H[ie].object),delete H[ie];delete O[$]}delete k[X],Object.keys(k).length===0&&delete i[U]}}}function E(){F(),o=!0,r!==s&&(r=s,c(r.object))}function F(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:E,resetDefaultState:F,dispose:R,releaseStatesOfGeometry:T,releaseStatesOfObject:v,releaseStatesOfProgram:N,initAttributes:_,enableAttribute:g,disableUnusedAttributes:S}}function oT(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];t.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function aT(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let N=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(N.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(N){return!(N!==ai&&i.convert(N)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(N){let v=N===ps&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(N!==Ri&&i.convert(N)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&N!==Pi&&!v)}function l(N){if(N==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";N="mediump"}return N==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&($e("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.logarithmicDepthBuffer===!0,d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control");t.reversedDepthBuffer===!0&&d===!1&&$e("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),S=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),C=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),T=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:p,maxTextureSize:_,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:S,maxVaryings:C,maxFragmentUniforms:b,maxSamples:R,samples:T}}function lT(n){let e=this,t=null,i=0,s=!1,r=!1,o=new ki,a=new it,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){let p=h.clippingPlanes,_=h.clipIntersection,g=h.clipShadows,m=n.get(h);if(!s||p===null||p.length===0||r&&!g)r?u(null):c();else{let S=r?0:i,C=S*4,b=m.clippingState||null;l.value=b,b=u(p,d,C,f);for(let R=0;R!==C;++R)b[R]=t[R];m.clippingState=b,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=S}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,d,f,p){let _=h!==null?h.length:0,g=null;if(_!==0){if(g=l.value,p!==!0||g===null){let m=f+_*4,S=d.matrixWorldInverse;a.getNormalMatrix(S),(g===null||g.length<m)&&(g=new Float32Array(m));for(let C=0,b=f;C!==_;++C,b+=4)o.copy(h[C]).applyMatrix4(S,a),o.normal.toArray(g,b),g[b+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=_,e.numIntersection=0,g}}var gr=4,T_=[.125,.215,.35,.446,.526,.582],Yr=20,cT=256,pl=new nl,E_=new pt,Zf=null,Kf=0,Jf=0,jf=!1,uT=new z,fh=class{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._sizeLods=[],this._sigmas=[],this._lodMeshes=[],this._backgroundBox=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=uT}=r;Zf=this._renderer.getRenderTarget(),Kf=this._renderer.getActiveCubeFace(),Jf=this._renderer.getActiveMipmapLevel(),jf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(e,i,s,l,a),t>0&&this._blur(l,0,0,t),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=R_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=C_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._backgroundBox!==null&&(this._backgroundBox.geometry.dispose(),this._backgroundBox.material.dispose())}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodMeshes.length;e++)this._lodMeshes[e].geometry.dispose()}_cleanup(e){this._renderer.setRenderTarget(Zf,Kf,Jf),this._renderer.xr.enabled=jf,e.scissorTest=!1,Qo(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===dr||e.mapping===qr?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),Zf=this._renderer.getRenderTarget(),Kf=this._renderer.getActiveCubeFace(),Jf=this._renderer.getActiveMipmapLevel(),jf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let i=t||this._allocateTargets();return this._textureToCubeUV(e,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){let e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,i={magFilter:En,minFilter:En,generateMipmaps:!1,type:ps,format:ai,colorSpace:ka,depthBuffer:!1},s=A_(e,t,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=A_(e,t,i);let{_lodMax:r}=this;({lodMeshes:this._lodMeshes,sizeLods:this._sizeLods,sigmas:this._sigmas}=hT(r)),this._blurMaterial=fT(r,e,t),this._ggxMaterial=dT(r,e,t)}return s}_compileMaterial(e){let t=new wt(new cn,e);this._renderer.compile(t,pl)}_sceneToCubeUV(e,t,i,s,r){let l=new Xn(90,1,t,i),c=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],h=this._renderer,d=h.autoClear,f=h.toneMapping;h.getClearColor(E_),h.toneMapping=es,h.autoClear=!1,h.state.buffers.depth.getReversed()&&(h.setRenderTarget(s),h.clearDepth(),h.setRenderTarget(null)),this._backgroundBox===null&&(this._backgroundBox=new wt(new ds,new $a({name:"PMREM.Background",side:oi,depthWrite:!1,depthTest:!1})));let _=this._backgroundBox,g=_.material,m=!1,S=e.background;S?S.isColor&&(g.color.copy(S),e.background=null,m=!0):(g.color.copy(E_),m=!0);for(let C=0;C<6;C++){let b=C%3;b===0?(l.up.set(0,c[C],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+u[C],r.y,r.z)):b===1?(l.up.set(0,0,c[C]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+u[C],r.z)):(l.up.set(0,c[C],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+u[C]));let R=this._cubeSize;Qo(s,b*R,C>2?R:0,R,R),h.setRenderTarget(s),m&&h.render(_,l),h.render(e,l)}h.toneMapping=f,h.autoClear=d,e.background=S}_textureToCubeUV(e,t){let i=this._renderer,s=e.mapping===dr||e.mapping===qr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=R_()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=C_());let r=s?this._cubemapMaterial:this._equirectMaterial,o=this._lodMeshes[0];o.material=r;let a=r.uniforms;a.envMap.value=e;let l=this._cubeSize;Qo(t,0,0,3*l,2*l),i.setRenderTarget(t),i.render(o,pl)}_applyPMREM(e){let t=this._renderer,i=t.autoClear;t.autoClear=!1;let s=this._lodMeshes.length;for(let r=1;r<s;r++)this._applyGGXFilter(e,r-1,r);t.autoClear=i}_applyGGXFilter(e,t,i){let s=this._renderer,r=this._pingPongRenderTarget,o=this._ggxMaterial,a=this._lodMeshes[i];a.material=o;let l=o.uniforms,c=i/(this._lodMeshes.length-1),u=t/(this._lodMeshes.length-1),h=Math.sqrt(c*c-u*u),d=0+c*1.25,f=h*d,{_lodMax:p}=this,_=this._sizeLods[i],g=3*_*(i>p-gr?i-p+gr:0),m=4*(this._cubeSize-_);l.envMap.value=e.texture,l.roughness.value=f,l.mipInt.value=p-t,Qo(r,g,m,3*_,2*_),s.setRenderTarget(r),s.render(a,pl),l.envMap.value=r.texture,l.roughness.value=0,l.mipInt.value=p-i,Qo(e,g,m,3*_,2*_),s.setRenderTarget(e),s.render(a,pl)}_blur(e,t,i,s,r){let o=this._pingPongRenderTarget;this._halfBlur(e,o,t,i,s,"latitudinal",r),this._halfBlur(o,e,i,i,s,"longitudinal",r)}_halfBlur(e,t,i,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&Je("blur direction must be either latitudinal or longitudinal!");let u=3,h=this._lodMeshes[s];h.material=c;let d=c.uniforms,f=this._sizeLods[i]-1,p=isFinite(r)?Math.PI/(2*f):2*Math.PI/(2*Yr-1),_=r/p,g=isFinite(r)?1+Math.floor(u*_):Yr;g>Yr&&$e(`sigmaRadians, ${r}, is too large and will clip, as it requested ${g} samples when the maximum is set to ${Yr}`);let m=[],S=0;for(let N=0;N<Yr;++N){let v=N/_,E=Math.exp(-v*v/2);m.push(E),N===0?S+=E:N<g&&(S+=2*E)}for(let N=0;N<m.length;N++)m[N]=m[N]/S;d.envMap.value=e.texture,d.samples.value=g,d.weights.value=m,d.latitudinal.value=o==="latitudinal",a&&(d.poleAxis.value=a);let{_lodMax:C}=this;d.dTheta.value=p,d.mipInt.value=C-i;let b=this._sizeLods[s],R=3*b*(s>C-gr?s-C+gr:0),T=4*(this._cubeSize-b);Qo(t,R,T,3*b,2*b),l.setRenderTarget(t),l.render(h,pl)}};function hT(n){let e=[],t=[],i=[],s=n,r=n-gr+1+T_.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);e.push(a);let l=1/a;o>n-gr?l=T_[o-n+gr-1]:o===0&&(l=0),t.push(l);let c=1/(a-2),u=-c,h=1+c,d=[u,u,h,u,h,h,u,u,h,h,u,h],f=6,p=6,_=3,g=2,m=1,S=new Float32Array(_*p*f),C=new Float32Array(g*p*f),b=new Float32Array(m*p*f);for(let T=0;T<f;T++){let N=T%3*2/3-1,v=T>2?0:-1,E=[N,v,0,N+2/3,v,0,N+2/3,v+1,0,N,v,0,N+2/3,v+1,0,N,v+1,0];S.set(E,_*p*T),C.set(d,g*p*T);let F=[T,T,T,T,T,T];b.set(F,m*p*T)}let R=new cn;R.setAttribute("position",new Tn(S,_)),R.setAttribute("uv",new Tn(C,g)),R.setAttribute("faceIndex",new Tn(b,m)),i.push(new wt(R,null)),s>gr&&s--}return{lodMeshes:i,sizeLods:e,sigmas:t}}function A_(n,e,t){let i=new Ai(n,e,t);return i.texture.mapping=ol,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function Qo(n,e,t,i,s){n.viewport.set(e,t,i,s),n.scissor.set(e,t,i,s)}function dT(n,e,t){return new en({name:"PMREMGGXConvolution",defines:{GGX_SAMPLES:cT,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},roughness:{value:0},mipInt:{value:0}},vertexShader:gh(),fragmentShader:`

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
		`,blending:fs,depthTest:!1,depthWrite:!1})}function fT(n,e,t){let i=new Float32Array(Yr),s=new z(0,1,0);return new en({name:"SphericalGaussianBlur",defines:{n:Yr,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:gh(),fragmentShader:`

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
		`,blending:fs,depthTest:!1,depthWrite:!1})}function C_(){return new en({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:gh(),fragmentShader:`

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
		`,blending:fs,depthTest:!1,depthWrite:!1})}function R_(){return new en({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:gh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:fs,depthTest:!1,depthWrite:!1})}function gh(){return`

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
	`}var ph=class extends Ai{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Ja(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ds(5,5,5),r=new en({name:"CubemapFromEquirect",uniforms:$r(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:oi,blending:fs});r.uniforms.tEquirect.value=t;let o=new wt(s,r),a=t.minFilter;return t.minFilter===fr&&(t.minFilter=En),new Mu(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}};function pT(n){let e=new WeakMap,t=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===wu||f===Tu)if(e.has(d)){let p=e.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let _=new ph(p.height);return _.fromEquirectangularTexture(n,d),e.set(d,_),d.addEventListener("dispose",c),a(_.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture){let f=d.mapping,p=f===wu||f===Tu,_=f===dr||f===qr;if(p||_){let g=t.get(d),m=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return i===null&&(i=new fh(n)),g=p?i.fromEquirectangular(d,g):i.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),g.texture;if(g!==void 0)return g.texture;{let S=d.image;return p&&S&&S.height>0||_&&S&&l(S)?(i===null&&(i=new fh(n)),g=p?i.fromEquirectangular(d):i.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),d.addEventListener("dispose",u),g.texture):null}}}return d}function a(d,f){return f===wu?d.mapping=dr:f===Tu&&(d.mapping=qr),d}function l(d){let f=0,p=6;for(let _=0;_<p;_++)d[_]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function mT(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&zr("WebGLRenderer: "+i+" extension not supported."),s}}}function gT(n,e,t,i){let s={},r=new WeakMap;function o(h){let d=h.target;d.index!==null&&e.remove(d.index);for(let p in d.attributes)e.remove(d.attributes[p]);d.removeEventListener("dispose",o),delete s[d.id];let f=r.get(d);f&&(e.remove(f),r.delete(d)),i.releaseStatesOfGeometry(d),d.isInstancedBufferGeometry===!0&&delete d._maxInstanceCount,t.memory.geometries--}function a(h,d){return s[d.id]===!0||(d.addEventListener("dispose",o),s[d.id]=!0,t.memory.geometries++),d}function l(h){let d=h.attributes;for(let f in d)e.update(d[f],n.ARRAY_BUFFER)}function c(h){let d=[],f=h.index,p=h.attributes.position,_=0;if(p===void 0)return;if(f!==null){let S=f.array;_=f.version;for(let C=0,b=S.length;C<b;C+=3){let R=S[C+0],T=S[C+1],N=S[C+2];d.push(R,T,T,N,N,R)}}else{let S=p.array;_=p.version;for(let C=0,b=S.length/3-1;C<b;C+=3){let R=C+0,T=C+1,N=C+2;d.push(R,T,T,N,N,R)}}let g=new(p.count>=65535?qa:Xa)(d,1);g.version=_;let m=r.get(h);m&&e.remove(m),r.set(h,g)}function u(h){let d=r.get(h);if(d){let f=h.index;f!==null&&d.version<f.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function _T(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),t.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),t.update(d,i,f))}function u(h,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let _=0;for(let g=0;g<f;g++)_+=d[g];t.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function xT(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:Je("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function yT(n,e,t){let i=new WeakMap,s=new Qt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let E=function(){N.dispose(),i.delete(a),a.removeEventListener("dispose",E)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],S=a.morphAttributes.color||[],C=0;f===!0&&(C=1),p===!0&&(C=2),_===!0&&(C=3);let b=a.attributes.position.count*C,R=1;b>e.maxTextureSize&&(R=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let T=new Float32Array(b*R*4*h),N=new Ga(T,b,R,h);N.type=Pi,N.needsUpdate=!0;let v=C*4;for(let F=0;F<h;F++){let I=g[F],U=m[F],k=S[F],X=b*R*4*F;for(let O=0;O<I.count;O++){let $=O*v;f===!0&&(s.fromBufferAttribute(I,O),T[X+$+0]=s.x,T[X+$+1]=s.y,T[X+$+2]=s.z,T[X+$+3]=0),p===!0&&(s.fromBufferAttribute(U,O),T[X+$+4]=s.x,T[X+$+5]=s.y,T[X+$+6]=s.z,T[X+$+7]=0),_===!0&&(s.fromBufferAttribute(k,O),T[X+$+8]=s.x,T[X+$+9]=s.y,T[X+$+10]=s.z,T[X+$+11]=k.itemSize===4?s.w:1)}}d={count:h,texture:N,size:new je(b,R)},i.set(a,d),a.addEventListener("dispose",E)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let _=0;_<c.length;_++)f+=c[_];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function vT(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=e.get(c,h);if(r.get(d)!==u&&(e.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var bT={[Tf]:"LINEAR_TONE_MAPPING",[Ef]:"REINHARD_TONE_MAPPING",[Af]:"CINEON_TONE_MAPPING",[Cf]:"ACES_FILMIC_TONE_MAPPING",[Pf]:"AGX_TONE_MAPPING",[If]:"NEUTRAL_TONE_MAPPING",[Rf]:"CUSTOM_TONE_MAPPING"};function MT(n,e,t,i,s,r){let o=new Ai(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,depthTexture:s?new Is(e,t):void 0}),a=new Ai(e,t,{type:ps,depthBuffer:!1,stencilBuffer:!1}),l=new cn;l.setAttribute("position",new Ft([-1,3,0,-1,-1,0,3,-1,0],3)),l.setAttribute("uv",new Ft([0,2,0,0,2,0],2));let c=new cu({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new wt(l,c),h=new nl(-1,1,1,-1,0,1),d=null,f=null,p=!1,_,g=null,m=[],S=!1;this.setSize=function(C,b){o.setSize(C,b),a.setSize(C,b);for(let R=0;R<m.length;R++){let T=m[R];T.setSize&&T.setSize(C,b)}},this.setEffects=function(C){m=C,S=m.length>0&&m[0].isRenderPass===!0;let b=o.width,R=o.height;for(let T=0;T<m.length;T++){let N=m[T];N.setSize&&N.setSize(b,R)}},this.begin=function(C,b){if(p||C.toneMapping===es&&m.length===0)return!1;if(g=b,b!==null){let R=b.width,T=b.height;(o.width!==R||o.height!==T)&&this.setSize(R,T)}return S===!1&&C.setRenderTarget(o),_=C.toneMapping,C.toneMapping=es,!0},this.hasRenderPass=function(){return S},this.end=function(C,b){C.toneMapping=_,p=!0;let R=o,T=a;for(let N=0;N<m.length;N++){let v=m[N];if(v.enabled!==!1&&(v.render(C,T,R,b),v.needsSwap!==!1)){let E=R;R=T,T=E}}if(d!==C.outputColorSpace||f!==C.toneMapping){d=C.outputColorSpace,f=C.toneMapping,c.defines={},xt.getTransfer(d)===Dt&&(c.defines.SRGB_TRANSFER="");let N=bT[f];N&&(c.defines[N]=""),c.needsUpdate=!0}c.uniforms.tDiffuse.value=R.texture,C.setRenderTarget(g),C.render(u,h),g=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.depthTexture&&o.depthTexture.dispose(),o.dispose(),a.dispose(),l.dispose(),c.dispose()}}var Z_=new ui,tp=new Is(1,1),K_=new Ga,J_=new su,j_=new Ja,P_=[],I_=[],L_=new Float32Array(16),N_=new Float32Array(9),D_=new Float32Array(4);function ta(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=P_[s];if(r===void 0&&(r=new Float32Array(s),P_[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function An(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Cn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function _h(n,e){let t=I_[e];t===void 0&&(t=new Int32Array(e),I_[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function ST(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function wT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(An(t,e))return;n.uniform2fv(this.addr,e),Cn(t,e)}}function TT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(An(t,e))return;n.uniform3fv(this.addr,e),Cn(t,e)}}function ET(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(An(t,e))return;n.uniform4fv(this.addr,e),Cn(t,e)}}function AT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(An(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Cn(t,e)}else{if(An(t,i))return;D_.set(i),n.uniformMatrix2fv(this.addr,!1,D_),Cn(t,i)}}function CT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(An(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Cn(t,e)}else{if(An(t,i))return;N_.set(i),n.uniformMatrix3fv(this.addr,!1,N_),Cn(t,i)}}function RT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(An(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Cn(t,e)}else{if(An(t,i))return;L_.set(i),n.uniformMatrix4fv(this.addr,!1,L_),Cn(t,i)}}function PT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function IT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(An(t,e))return;n.uniform2iv(this.addr,e),Cn(t,e)}}function LT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(An(t,e))return;n.uniform3iv(this.addr,e),Cn(t,e)}}function NT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(An(t,e))return;n.uniform4iv(this.addr,e),Cn(t,e)}}function DT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function FT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(An(t,e))return;n.uniform2uiv(this.addr,e),Cn(t,e)}}function UT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(An(t,e))return;n.uniform3uiv(this.addr,e),Cn(t,e)}}function OT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(An(t,e))return;n.uniform4uiv(this.addr,e),Cn(t,e)}}function kT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?(tp.compareFunction=t.isReversedDepthBuffer()?uh:ch,r=tp):r=Z_,t.setTexture2D(e||r,s)}function BT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||J_,s)}function VT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTextureCube(e||j_,s)}function zT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||K_,s)}function GT(n){switch(n){case 5126:return ST;case 35664:return wT;case 35665:return TT;case 35666:return ET;case 35674:return AT;case 35675:return CT;case 35676:return RT;case 5124:case 35670:return PT;case 35667:case 35671:return IT;case 35668:case 35672:return LT;case 35669:case 35673:return NT;case 5125:return DT;case 36294:return FT;case 36295:return UT;case 36296:return OT;case 35678:case 36198:case 36298:case 36306:case 35682:return kT;case 35679:case 36299:case 36307:return BT;case 35680:case 36300:case 36308:case 36293:return VT;case 36289:case 36303:case 36311:case 36292:return zT}}function HT(n,e){n.uniform1fv(this.addr,e)}function WT(n,e){let t=ta(e,this.size,2);n.uniform2fv(this.addr,t)}function XT(n,e){let t=ta(e,this.size,3);n.uniform3fv(this.addr,t)}function qT(n,e){let t=ta(e,this.size,4);n.uniform4fv(this.addr,t)}function $T(n,e){let t=ta(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function YT(n,e){let t=ta(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function ZT(n,e){let t=ta(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function KT(n,e){n.uniform1iv(this.addr,e)}function JT(n,e){n.uniform2iv(this.addr,e)}function jT(n,e){n.uniform3iv(this.addr,e)}function QT(n,e){n.uniform4iv(this.addr,e)}function eE(n,e){n.uniform1uiv(this.addr,e)}function tE(n,e){n.uniform2uiv(this.addr,e)}function nE(n,e){n.uniform3uiv(this.addr,e)}function iE(n,e){n.uniform4uiv(this.addr,e)}function sE(n,e,t){let i=this.cache,s=e.length,r=_h(t,s);An(i,r)||(n.uniform1iv(this.addr,r),Cn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=tp:o=Z_;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function rE(n,e,t){let i=this.cache,s=e.length,r=_h(t,s);An(i,r)||(n.uniform1iv(this.addr,r),Cn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||J_,r[o])}function oE(n,e,t){let i=this.cache,s=e.length,r=_h(t,s);An(i,r)||(n.uniform1iv(this.addr,r),Cn(i,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||j_,r[o])}function aE(n,e,t){let i=this.cache,s=e.length,r=_h(t,s);An(i,r)||(n.uniform1iv(this.addr,r),Cn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||K_,r[o])}function lE(n){switch(n){case 5126:return HT;case 35664:return WT;case 35665:return XT;case 35666:return qT;case 35674:return $T;case 35675:return YT;case 35676:return ZT;case 5124:case 35670:return KT;case 35667:case 35671:return JT;case 35668:case 35672:return jT;case 35669:case 35673:return QT;case 5125:return eE;case 36294:return tE;case 36295:return nE;case 36296:return iE;case 35678:case 36198:case 36298:case 36306:case 35682:return sE;case 35679:case 36299:case 36307:return rE;case 35680:case 36300:case 36308:case 36293:return oE;case 36289:case 36303:case 36311:case 36292:return aE}}var np=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=GT(t.type)}},ip=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=lE(t.type)}},sp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},Qf=/(\w+)(\])?(\[|\.)?/g;function F_(n,e){n.seq.push(e),n.map[e.id]=e}function cE(n,e,t){let i=n.name,s=i.length;for(Qf.lastIndex=0;;){let r=Qf.exec(i),o=Qf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){F_(t,c===void 0?new np(a,n,e):new ip(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new sp(a),F_(t,h)),t=h}}}var ea=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);cE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function U_(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var uE=37297,hE=0;function dE(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var O_=new it;function fE(n){xt._getMatrix(O_,xt.workingColorSpace,n);let e=`mat3( ${O_.elements.map(t=>t.toFixed(4))} )`;switch(xt.getTransfer(n)){case Ba:return[e,"LinearTransferOETF"];case Dt:return[e,"sRGBTransferOETF"];default:return $e("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function k_(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+dE(n.getShaderSource(e),a)}else return r}function pE(n,e){let t=fE(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}var mE={[Tf]:"Linear",[Ef]:"Reinhard",[Af]:"Cineon",[Cf]:"ACESFilmic",[Pf]:"AgX",[If]:"Neutral",[Rf]:"Custom"};function gE(n,e){let t=mE[e];return t===void 0?($e("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var dh=new z;function _E(){xt.getLuminanceCoefficients(dh);let n=dh.x.toFixed(4),e=dh.y.toFixed(4),t=dh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function xE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(gl).join(`
`)}function yE(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function vE(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function gl(n){return n!==""}function B_(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function V_(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var bE=/^[ \t]*#include +<([\w\d./]+)>/gm;function rp(n){return n.replace(bE,SE)}var ME=new Map;function SE(n,e){let t=at[e];if(t===void 0){let i=ME.get(e);if(i!==void 0)t=at[i],$e('WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,i);else throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">")}return rp(t)}var wE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function z_(n){return n.replace(wE,TE)}function TE(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function G_(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var EE={[rl]:"SHADOWMAP_TYPE_PCF",[Zo]:"SHADOWMAP_TYPE_VSM"};function AE(n){return EE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var CE={[dr]:"ENVMAP_TYPE_CUBE",[qr]:"ENVMAP_TYPE_CUBE",[ol]:"ENVMAP_TYPE_CUBE_UV"};function RE(n){return n.envMap===!1?"ENVMAP_TYPE_CUBE":CE[n.envMapMode]||"ENVMAP_TYPE_CUBE"}var PE={[qr]:"ENVMAP_MODE_REFRACTION"};function IE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":PE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var LE={[wf]:"ENVMAP_BLENDING_MULTIPLY",[a_]:"ENVMAP_BLENDING_MIX",[l_]:"ENVMAP_BLENDING_ADD"};function NE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":LE[n.combine]||"ENVMAP_BLENDING_NONE"}function DE(n){let e=n.envMapCubeUVHeight;if(e===null)return null;let t=Math.log2(e)-2,i=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:i,maxMip:t}}function FE(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=AE(t),c=RE(t),u=IE(t),h=NE(t),d=DE(t),f=xE(t),p=yE(r),_=s.createProgram(),g,m,S=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(gl).join(`
`),g.length>0&&(g+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(gl).join(`
`),m.length>0&&(m+=`
`)):(g=[G_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(gl).join(`
`),m=[G_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",d?"#define CUBEUV_TEXEL_WIDTH "+d.texelWidth:"",d?"#define CUBEUV_TEXEL_HEIGHT "+d.texelHeight:"",d?"#define CUBEUV_MAX_MIP "+d.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.numLightProbeGrids>0?"#define USE_LIGHT_PROBES_GRID":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==es?"#define TONE_MAPPING":"",t.toneMapping!==es?at.tonemapping_pars_fragment:"",t.toneMapping!==es?gE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",at.colorspace_pars_fragment,pE("linearToOutputTexel",t.outputColorSpace),_E(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(gl).join(`
`)),o=rp(o),o=B_(o,t),o=V_(o,t),a=rp(a),a=B_(a,t),a=V_(a,t),o=z_(o),a=z_(a),t.isRawShaderMaterial!==!0&&(S=`#version 300 es
`,g=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+g,m=["#define varying in",t.glslVersion===zf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===zf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let C=S+g+o,b=S+m+a,R=U_(s,s.VERTEX_SHADER,C),T=U_(s,s.FRAGMENT_SHADER,b);s.attachShader(_,R),s.attachShader(_,T),t.index0AttributeName!==void 0?s.bindAttribLocation(_,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(_,0,"position"),s.linkProgram(_);function N(I){if(n.debug.checkShaderErrors){let U=s.getProgramInfoLog(_)||"",k=s.getShaderInfoLog(R)||"",X=s.getShaderInfoLog(T)||"",O=U.trim(),$=k.trim(),H=X.trim(),ie=!0,oe=!0;if(s.getProgramParameter(_,s.LINK_STATUS)===!1)if(ie=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,_,R,T);else{let le=k_(s,R,"vertex"),de=k_(s,T,"fragment");Je("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(_,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+O+`
`+le+`
`+de)}else O!==""?$e("WebGLProgram: Program Info Log:",O):($===""||H==="")&&(oe=!1);oe&&(I.diagnostics={runnable:ie,programLog:O,vertexShader:{log:$,prefix:g},fragmentShader:{log:H,prefix:m}})}s.deleteShader(R),s.deleteShader(T),v=new ea(s,_),E=vE(s,_)}let v;this.getUniforms=function(){return v===void 0&&N(this),v};let E;this.getAttributes=function(){return E===void 0&&N(this),E};let F=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return F===!1&&(F=s.getProgramParameter(_,uE)),F},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(_),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=hE++,this.cacheKey=e,this.usedTimes=1,this.program=_,this.vertexShader=R,this.fragmentShader=T,this}var UE=0,op=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new ap(e),t.set(e,i)),i}},ap=class{constructor(e){this.id=UE++,this.code=e,this.usedTimes=0}};function OE(n){return n===mr||n===dl||n===fl}function kE(n,e,t,i,s,r){let o=new Ha,a=new op,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d=i.precision,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(v){return l.add(v),v===0?"uv":`uv${v}`}function _(v,E,F,I,U,k){let X=I.fog,O=U.geometry,$=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?I.environment:null,H=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,ie=e.get(v.envMap||$,H),oe=ie&&ie.mapping===ol?ie.image.height:null,le=f[v.type];v.precision!==null&&(d=i.getMaxPrecision(v.precision),d!==v.precision&&$e("WebGLProgram.getParameters:",v.precision,"not supported, using",d,"instead."));let de=O.morphAttributes.position||O.morphAttributes.normal||O.morphAttributes.color,ue=de!==void 0?de.length:0,_e=0;O.morphAttributes.position!==void 0&&(_e=1),O.morphAttributes.normal!==void 0&&(_e=2),O.morphAttributes.color!==void 0&&(_e=3);let st,et,Q,ae;if(le){let Ne=gs[le];st=Ne.vertexShader,et=Ne.fragmentShader}else{st=v.vertexShader,et=v.fragmentShader;let Ne=a.getVertexShaderStage(v),lt=a.getFragmentShaderStage(v);a.update(v,Ne,lt),Q=Ne.id,ae=lt.id}let he=n.getRenderTarget(),Ve=n.state.buffers.depth.getReversed(),De=U.isInstancedMesh===!0,ke=U.isBatchedMesh===!0,Tt=!!v.map,Ze=!!v.matcap,mt=!!ie,ct=!!v.aoMap,ot=!!v.lightMap,qt=!!v.bumpMap&&v.wireframe===!1,tn=!!v.normalMap,$t=!!v.displacementMap,bt=!!v.emissiveMap,Ut=!!v.metalnessMap,It=!!v.roughnessMap,G=v.anisotropy>0,We=v.clearcoat>0,fe=v.dispersion>0,P=v.iridescence>0,y=v.sheen>0,q=v.transmission>0,K=G&&!!v.anisotropyMap,ee=We&&!!v.clearcoatMap,me=We&&!!v.clearcoatNormalMap,ge=We&&!!v.clearcoatRoughnessMap,te=P&&!!v.iridescenceMap,ne=P&&!!v.iridescenceThicknessMap,xe=y&&!!v.sheenColorMap,Be=y&&!!v.sheenRoughnessMap,Me=!!v.specularMap,ve=!!v.specularColorMap,Oe=!!v.specularIntensityMap,Xe=q&&!!v.transmissionMap,qe=q&&!!v.thicknessMap,V=!!v.gradientMap,be=!!v.alphaMap,se=v.alphaTest>0,Se=!!v.alphaHash,Ae=!!v.extensions,ce=es;v.toneMapped&&(he===null||he.isXRRenderTarget===!0)&&(ce=n.toneMapping);let ze={shaderID:le,shaderType:v.type,shaderName:v.name,vertexShader:st,fragmentShader:et,defines:v.defines,customVertexShaderID:Q,customFragmentShaderID:ae,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:d,batching:ke,batchingColor:ke&&U._colorsTexture!==null,instancing:De,instancingColor:De&&U.instanceColor!==null,instancingMorph:De&&U.morphTexture!==null,outputColorSpace:he===null?n.outputColorSpace:he.isXRRenderTarget===!0?he.texture.colorSpace:xt.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Tt,matcap:Ze,envMap:mt,envMapMode:mt&&ie.mapping,envMapCubeUVHeight:oe,aoMap:ct,lightMap:ot,bumpMap:qt,normalMap:tn,displacementMap:$t,emissiveMap:bt,normalMapObjectSpace:tn&&v.normalMapType===h_,normalMapTangentSpace:tn&&v.normalMapType===Vf,packedNormalMap:tn&&v.normalMapType===Vf&&OE(v.normalMap.format),metalnessMap:Ut,roughnessMap:It,anisotropy:G,anisotropyMap:K,clearcoat:We,clearcoatMap:ee,clearcoatNormalMap:me,clearcoatRoughnessMap:ge,dispersion:fe,iridescence:P,iridescenceMap:te,iridescenceThicknessMap:ne,sheen:y,sheenColorMap:xe,sheenRoughnessMap:Be,specularMap:Me,specularColorMap:ve,specularIntensityMap:Oe,transmission:q,transmissionMap:Xe,thicknessMap:qe,gradientMap:V,opaque:v.transparent===!1&&v.blending===Gr&&v.alphaToCoverage===!1,alphaMap:be,alphaTest:se,alphaHash:Se,combine:v.combine,mapUv:Tt&&p(v.map.channel),aoMapUv:ct&&p(v.aoMap.channel),lightMapUv:ot&&p(v.lightMap.channel),bumpMapUv:qt&&p(v.bumpMap.channel),normalMapUv:tn&&p(v.normalMap.channel),displacementMapUv:$t&&p(v.displacementMap.channel),emissiveMapUv:bt&&p(v.emissiveMap.channel),metalnessMapUv:Ut&&p(v.metalnessMap.channel),roughnessMapUv:It&&p(v.roughnessMap.channel),anisotropyMapUv:K&&p(v.anisotropyMap.channel),clearcoatMapUv:ee&&p(v.clearcoatMap.channel),clearcoatNormalMapUv:me&&p(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:ge&&p(v.clearcoatRoughnessMap.channel),iridescenceMapUv:te&&p(v.iridescenceMap.channel),iridescenceThicknessMapUv:ne&&p(v.iridescenceThicknessMap.channel),sheenColorMapUv:xe&&p(v.sheenColorMap.channel),sheenRoughnessMapUv:Be&&p(v.sheenRoughnessMap.channel),specularMapUv:Me&&p(v.specularMap.channel),specularColorMapUv:ve&&p(v.specularColorMap.channel),specularIntensityMapUv:Oe&&p(v.specularIntensityMap.channel),transmissionMapUv:Xe&&p(v.transmissionMap.channel),thicknessMapUv:qe&&p(v.thicknessMap.channel),alphaMapUv:be&&p(v.alphaMap.channel),vertexTangents:!!O.attributes.tangent&&(tn||G),vertexNormals:!!O.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!O.attributes.color&&O.attributes.color.itemSize===4,pointsUvs:U.isPoints===!0&&!!O.attributes.uv&&(Tt||be),fog:!!X,useFog:v.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||O.attributes.normal===void 0&&tn===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Ve,skinning:U.isSkinnedMesh===!0,hasPositionAttribute:O.attributes.position!==void 0,morphTargets:O.morphAttributes.position!==void 0,morphNormals:O.morphAttributes.normal!==void 0,morphColors:O.morphAttributes.color!==void 0,morphTargetsCount:ue,morphTextureStride:_e,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:k.length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&F.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:Tt&&v.map.isVideoTexture===!0&&xt.getTransfer(v.map.colorSpace)===Dt,decodeVideoTextureEmissive:bt&&v.emissiveMap.isVideoTexture===!0&&xt.getTransfer(v.emissiveMap.colorSpace)===Dt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===$n,flipSided:v.side===oi,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Ae&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ae&&v.extensions.multiDraw===!0||ke)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return ze.vertexUv1s=l.has(1),ze.vertexUv2s=l.has(2),ze.vertexUv3s=l.has(3),l.clear(),ze}function g(v){let E=[];if(v.shaderID?E.push(v.shaderID):(E.push(v.customVertexShaderID),E.push(v.customFragmentShaderID)),v.defines!==void 0)for(let F in v.defines)E.push(F),E.push(v.defines[F]);return v.isRawShaderMaterial===!1&&(m(E,v),S(E,v),E.push(n.outputColorSpace)),E.push(v.customProgramCacheKey),E.join()}function m(v,E){v.push(E.precision),v.push(E.outputColorSpace),v.push(E.envMapMode),v.push(E.envMapCubeUVHeight),v.push(E.mapUv),v.push(E.alphaMapUv),v.push(E.lightMapUv),v.push(E.aoMapUv),v.push(E.bumpMapUv),v.push(E.normalMapUv),v.push(E.displacementMapUv),v.push(E.emissiveMapUv),v.push(E.metalnessMapUv),v.push(E.roughnessMapUv),v.push(E.anisotropyMapUv),v.push(E.clearcoatMapUv),v.push(E.clearcoatNormalMapUv),v.push(E.clearcoatRoughnessMapUv),v.push(E.iridescenceMapUv),v.push(E.iridescenceThicknessMapUv),v.push(E.sheenColorMapUv),v.push(E.sheenRoughnessMapUv),v.push(E.specularMapUv),v.push(E.specularColorMapUv),v.push(E.specularIntensityMapUv),v.push(E.transmissionMapUv),v.push(E.thicknessMapUv),v.push(E.combine),v.push(E.fogExp2),v.push(E.sizeAttenuation),v.push(E.morphTargetsCount),v.push(E.morphAttributeCount),v.push(E.numDirLights),v.push(E.numPointLights),v.push(E.numSpotLights),v.push(E.numSpotLightMaps),v.push(E.numHemiLights),v.push(E.numRectAreaLights),v.push(E.numDirLightShadows),v.push(E.numPointLightShadows),v.push(E.numSpotLightShadows),v.push(E.numSpotLightShadowsWithMaps),v.push(E.numLightProbes),v.push(E.shadowMapType),v.push(E.toneMapping),v.push(E.numClippingPlanes),v.push(E.numClipIntersection),v.push(E.depthPacking)}function S(v,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function C(v){let E=f[v.type],F;if(E){let I=gs[E];F=S_.clone(I.uniforms)}else F=v.uniforms;return F}function b(v,E){let F=u.get(E);return F!==void 0?++F.usedTimes:(F=new FE(n,E,v,s),c.push(F),u.set(E,F)),F}function R(v){if(--v.usedTimes===0){let E=c.indexOf(v);c[E]=c[c.length-1],c.pop(),u.delete(v.cacheKey),v.destroy()}}function T(v){a.remove(v)}function N(){a.dispose()}return{getParameters:_,getProgramCacheKey:g,getUniforms:C,acquireProgram:b,releaseProgram:R,releaseShaderCache:T,programs:c,dispose:N}}function BE(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function VE(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function H_(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function W_(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,_,g,m){let S=n[e];return S===void 0?(S={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:_,renderOrder:d.renderOrder,z:g,group:m},n[e]=S):(S.id=d.id,S.object=d,S.geometry=f,S.material=p,S.materialVariant=o(d),S.groupOrder=_,S.renderOrder=d.renderOrder,S.z=g,S.group=m),e++,S}function l(d,f,p,_,g,m){let S=a(d,f,p,_,g,m);p.transmission>0?i.push(S):p.transparent===!0?s.push(S):t.push(S)}function c(d,f,p,_,g,m){let S=a(d,f,p,_,g,m);p.transmission>0?i.unshift(S):p.transparent===!0?s.unshift(S):t.unshift(S)}function u(d,f,p){t.length>1&&t.sort(d||VE),i.length>1&&i.sort(f||H_),s.length>1&&s.sort(f||H_),p&&(t.reverse(),i.reverse(),s.reverse())}function h(){for(let d=e,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function zE(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new W_,n.set(i,[o])):s>=r.length?(o=new W_,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function GE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new z,color:new pt};break;case"SpotLight":t={position:new z,direction:new z,color:new pt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new z,color:new pt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new z,skyColor:new pt,groundColor:new pt};break;case"RectAreaLight":t={color:new pt,position:new z,halfWidth:new z,halfHeight:new z};break}return n[e.id]=t,t}}}function HE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new je};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new je};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new je,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var WE=0;function XE(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function qE(n){let e=new GE,t=HE(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new z);let s=new z,r=new Vt,o=new Vt;function a(c){let u=0,h=0,d=0;for(let E=0;E<9;E++)i.probe[E].set(0,0,0);let f=0,p=0,_=0,g=0,m=0,S=0,C=0,b=0,R=0,T=0,N=0;c.sort(XE);for(let E=0,F=c.length;E<F;E++){let I=c[E],U=I.color,k=I.intensity,X=I.distance,O=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===mr?O=I.shadow.map.texture:O=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)u+=U.r*k,h+=U.g*k,d+=U.b*k;else if(I.isLightProbe){for(let $=0;$<9;$++)i.probe[$].addScaledVector(I.sh.coefficients[$],k);N++}else if(I.isDirectionalLight){let $=e.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let H=I.shadow,ie=t.get(I);ie.shadowIntensity=H.intensity,ie.shadowBias=H.bias,ie.shadowNormalBias=H.normalBias,ie.shadowRadius=H.radius,ie.shadowMapSize=H.mapSize,i.directionalShadow[f]=ie,i.directionalShadowMap[f]=O,i.directionalShadowMatrix[f]=I.shadow.matrix,S++}i.directional[f]=$,f++}else if(I.isSpotLight){let $=e.get(I);$.position.setFromMatrixPosition(I.matrixWorld),$.color.copy(U).multiplyScalar(k),$.distance=X,$.coneCos=Math.cos(I.angle),$.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),$.decay=I.decay,i.spot[_]=$;let H=I.shadow;if(I.map&&(i.spotLightMap[R]=I.map,R++,H.updateMatrices(I),I.castShadow&&T++),i.spotLightMatrix[_]=H.matrix,I.castShadow){let ie=t.get(I);ie.shadowIntensity=H.intensity,ie.shadowBias=H.bias,ie.shadowNormalBias=H.normalBias,ie.shadowRadius=H.radius,ie.shadowMapSize=H.mapSize,i.spotShadow[_]=ie,i.spotShadowMap[_]=O,b++}_++}else if(I.isRectAreaLight){let $=e.get(I);$.color.copy(U).multiplyScalar(k),$.halfWidth.set(I.width*.5,0,0),$.halfHeight.set(0,I.height*.5,0),i.rectArea[g]=$,g++}else if(I.isPointLight){let $=e.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),$.distance=I.distance,$.decay=I.decay,I.castShadow){let H=I.shadow,ie=t.get(I);ie.shadowIntensity=H.intensity,ie.shadowBias=H.bias,ie.shadowNormalBias=H.normalBias,ie.shadowRadius=H.radius,ie.shadowMapSize=H.mapSize,ie.shadowCameraNear=H.camera.near,ie.shadowCameraFar=H.camera.far,i.pointShadow[p]=ie,i.pointShadowMap[p]=O,i.pointShadowMatrix[p]=I.shadow.matrix,C++}i.point[p]=$,p++}else if(I.isHemisphereLight){let $=e.get(I);$.skyColor.copy(I.color).multiplyScalar(k),$.groundColor.copy(I.groundColor).multiplyScalar(k),i.hemi[m]=$,m++}}g>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ee.LTC_FLOAT_1,i.rectAreaLTC2=Ee.LTC_FLOAT_2):(i.rectAreaLTC1=Ee.LTC_HALF_1,i.rectAreaLTC2=Ee.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let v=i.hash;(v.directionalLength!==f||v.pointLength!==p||v.spotLength!==_||v.rectAreaLength!==g||v.hemiLength!==m||v.numDirectionalShadows!==S||v.numPointShadows!==C||v.numSpotShadows!==b||v.numSpotMaps!==R||v.numLightProbes!==N)&&(i.directional.length=f,i.spot.length=_,i.rectArea.length=g,i.point.length=p,i.hemi.length=m,i.directionalShadow.length=S,i.directionalShadowMap.length=S,i.pointShadow.length=C,i.pointShadowMap.length=C,i.spotShadow.length=b,i.spotShadowMap.length=b,i.directionalShadowMatrix.length=S,i.pointShadowMatrix.length=C,i.spotLightMatrix.length=b+R-T,i.spotLightMap.length=R,i.numSpotLightShadowsWithMaps=T,i.numLightProbes=N,v.directionalLength=f,v.pointLength=p,v.spotLength=_,v.rectAreaLength=g,v.hemiLength=m,v.numDirectionalShadows=S,v.numPointShadows=C,v.numSpotShadows=b,v.numSpotMaps=R,v.numLightProbes=N,i.version=WE++)}function l(c,u){let h=0,d=0,f=0,p=0,_=0,g=u.matrixWorldInverse;for(let m=0,S=c.length;m<S;m++){let C=c[m];if(C.isDirectionalLight){let b=i.directional[h];b.direction.setFromMatrixPosition(C.matrixWorld),s.setFromMatrixPosition(C.target.matrixWorld),b.direction.sub(s),b.direction.transformDirection(g),h++}else if(C.isSpotLight){let b=i.spot[f];b.position.setFromMatrixPosition(C.matrixWorld),b.position.applyMatrix4(g),b.direction.setFromMatrixPosition(C.matrixWorld),s.setFromMatrixPosition(C.target.matrixWorld),b.direction.sub(s),b.direction.transformDirection(g),f++}else if(C.isRectAreaLight){let b=i.rectArea[p];b.position.setFromMatrixPosition(C.matrixWorld),b.position.applyMatrix4(g),o.identity(),r.copy(C.matrixWorld),r.premultiply(g),o.extractRotation(r),b.halfWidth.set(C.width*.5,0,0),b.halfHeight.set(0,C.height*.5,0),b.halfWidth.applyMatrix4(o),b.halfHeight.applyMatrix4(o),p++}else if(C.isPointLight){let b=i.point[d];b.position.setFromMatrixPosition(C.matrixWorld),b.position.applyMatrix4(g),d++}else if(C.isHemisphereLight){let b=i.hemi[_];b.direction.setFromMatrixPosition(C.matrixWorld),b.direction.transformDirection(g),_++}}}return{setup:a,setupView:l,state:i}}function X_(n){let e=new qE(n),t=[],i=[],s=[];function r(d){h.camera=d,t.length=0,i.length=0,s.length=0}function o(d){t.push(d)}function a(d){i.push(d)}function l(d){s.push(d)}function c(){e.setup(t)}function u(d){e.setupView(t,d)}let h={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:u,pushLight:o,pushShadow:a,pushLightProbeGrid:l}}function $E(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new X_(n),e.set(s,[a])):r>=o.length?(a=new X_(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var YE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,ZE=`uniform sampler2D shadow_pass;
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
}`,KE=[new z(1,0,0),new z(-1,0,0),new z(0,1,0),new z(0,-1,0),new z(0,0,1),new z(0,0,-1)],JE=[new z(0,-1,0),new z(0,-1,0),new z(0,0,1),new z(0,0,-1),new z(0,-1,0),new z(0,-1,0)],q_=new Vt,ml=new z,ep=new z;function jE(n,e,t){let i=new Za,s=new je,r=new je,o=new Qt,a=new uu,l=new hu,c={},u=t.maxTextureSize,h={[ji]:oi,[oi]:ji,[$n]:$n},d=new en({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new je},radius:{value:4}},vertexShader:YE,fragmentShader:ZE}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new cn;p.setAttribute("position",new Tn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new wt(p,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=rl;let m=this.type;this.render=function(T,N,v){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||T.length===0)return;this.type===G0&&($e("WebGLShadowMap: PCFSoftShadowMap has been deprecated. Using PCFShadowMap instead."),this.type=rl);let E=n.getRenderTarget(),F=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),U=n.state;U.setBlending(fs),U.buffers.depth.getReversed()===!0?U.buffers.color.setClear(0,0,0,0):U.buffers.color.setClear(1,1,1,1),U.buffers.depth.setTest(!0),U.setScissorTest(!1);let k=m!==this.type;k&&N.traverse(function(X){X.material&&(Array.isArray(X.material)?X.material.forEach(O=>O.needsUpdate=!0):X.material.needsUpdate=!0)});for(let X=0,O=T.length;X<O;X++){let $=T[X],H=$.shadow;if(H===void 0){$e("WebGLShadowMap:",$,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let ie=H.getFrameExtents();s.multiply(ie),r.copy(H.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ie.x),s.x=r.x*ie.x,H.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ie.y),s.y=r.y*ie.y,H.mapSize.y=r.y));let oe=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=oe,H.map===null||k===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===Zo){if($.isPointLight){$e("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new Ai(s.x,s.y,{format:mr,type:ps,minFilter:En,magFilter:En,generateMipmaps:!1}),H.map.texture.name=$.name+".shadowMap",H.map.depthTexture=new Is(s.x,s.y,Pi),H.map.depthTexture.name=$.name+".shadowMapDepth",H.map.depthTexture.format=hs,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=vn,H.map.depthTexture.magFilter=vn}else $.isPointLight?(H.map=new ph(s.x),H.map.depthTexture=new lu(s.x,ts)):(H.map=new Ai(s.x,s.y),H.map.depthTexture=new Is(s.x,s.y,ts)),H.map.depthTexture.name=$.name+".shadowMap",H.map.depthTexture.format=hs,this.type===rl?(H.map.depthTexture.compareFunction=oe?uh:ch,H.map.depthTexture.minFilter=En,H.map.depthTexture.magFilter=En):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=vn,H.map.depthTexture.magFilter=vn);H.camera.updateProjectionMatrix()}let le=H.map.isWebGLCubeRenderTarget?6:1;for(let de=0;de<le;de++){if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,de),n.clear();else{de===0&&(n.setRenderTarget(H.map),n.clear());let ue=H.getViewport(de);o.set(r.x*ue.x,r.y*ue.y,r.x*ue.z,r.y*ue.w),U.viewport(o)}if($.isPointLight){let ue=H.camera,_e=H.matrix,st=$.distance||ue.far;st!==ue.far&&(ue.far=st,ue.updateProjectionMatrix()),ml.setFromMatrixPosition($.matrixWorld),ue.position.copy(ml),ep.copy(ue.position),ep.add(KE[de]),ue.up.copy(JE[de]),ue.lookAt(ep),ue.updateMatrixWorld(),_e.makeTranslation(-ml.x,-ml.y,-ml.z),q_.multiplyMatrices(ue.projectionMatrix,ue.matrixWorldInverse),H._frustum.setFromProjectionMatrix(q_,ue.coordinateSystem,ue.reversedDepth)}else H.updateMatrices($);i=H.getFrustum(),b(N,v,H.camera,$,this.type)}H.isPointLightShadow!==!0&&this.type===Zo&&S(H,v),H.needsUpdate=!1}m=this.type,g.needsUpdate=!1,n.setRenderTarget(E,F,I)};function S(T,N){let v=e.update(_);d.defines.VSM_SAMPLES!==T.blurSamples&&(d.defines.VSM_SAMPLES=T.blurSamples,f.defines.VSM_SAMPLES=T.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),T.mapPass===null&&(T.mapPass=new Ai(s.x,s.y,{format:mr,type:ps})),d.uniforms.shadow_pass.value=T.map.depthTexture,d.uniforms.resolution.value=T.mapSize,d.uniforms.radius.value=T.radius,n.setRenderTarget(T.mapPass),n.clear(),n.renderBufferDirect(N,null,v,d,_,null),f.uniforms.shadow_pass.value=T.mapPass.texture,f.uniforms.resolution.value=T.mapSize,f.uniforms.radius.value=T.radius,n.setRenderTarget(T.map),n.clear(),n.renderBufferDirect(N,null,v,f,_,null)}function C(T,N,v,E){let F=null,I=v.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(I!==void 0)F=I;else if(F=v.isPointLight===!0?l:a,n.localClippingEnabled&&N.clipShadows===!0&&Array.isArray(N.clippingPlanes)&&N.clippingPlanes.length!==0||N.displacementMap&&N.displacementScale!==0||N.alphaMap&&N.alphaTest>0||N.map&&N.alphaTest>0||N.alphaToCoverage===!0){let U=F.uuid,k=N.uuid,X=c[U];X===void 0&&(X={},c[U]=X);let O=X[k];O===void 0&&(O=F.clone(),X[k]=O,N.addEventListener("dispose",R)),F=O}if(F.visible=N.visible,F.wireframe=N.wireframe,E===Zo?F.side=N.shadowSide!==null?N.shadowSide:N.side:F.side=N.shadowSide!==null?N.shadowSide:h[N.side],F.alphaMap=N.alphaMap,F.alphaTest=N.alphaToCoverage===!0?.5:N.alphaTest,F.map=N.map,F.clipShadows=N.clipShadows,F.clippingPlanes=N.clippingPlanes,F.clipIntersection=N.clipIntersection,F.displacementMap=N.displacementMap,F.displacementScale=N.displacementScale,F.displacementBias=N.displacementBias,F.wireframeLinewidth=N.wireframeLinewidth,F.linewidth=N.linewidth,v.isPointLight===!0&&F.isMeshDistanceMaterial===!0){let U=n.properties.get(F);U.light=v}return F}function b(T,N,v,E,F){if(T.visible===!1)return;if(T.layers.test(N.layers)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&F===Zo)&&(!T.frustumCulled||i.intersectsObject(T))){T.modelViewMatrix.multiplyMatrices(v.matrixWorldInverse,T.matrixWorld);let k=e.update(T),X=T.material;if(Array.isArray(X)){let O=k.groups;for(let $=0,H=O.length;$<H;$++){let ie=O[$],oe=X[ie.materialIndex];if(oe&&oe.visible){let le=C(T,oe,E,F);T.onBeforeShadow(n,T,N,v,k,le,ie),n.renderBufferDirect(v,null,k,le,T,ie),T.onAfterShadow(n,T,N,v,k,le,ie)}}}else if(X.visible){let O=C(T,X,E,F);T.onBeforeShadow(n,T,N,v,k,O,null),n.renderBufferDirect(v,null,k,O,T,null),T.onAfterShadow(n,T,N,v,k,O,null)}}let U=T.children;for(let k=0,X=U.length;k<X;k++)b(U[k],N,v,E,F)}function R(T){T.target.removeEventListener("dispose",R);for(let v in c){let E=c[v],F=T.target.uuid;F in E&&(E[F].dispose(),delete E[F])}}}function QE(n,e){function t(){let V=!1,be=new Qt,se=null,Se=new Qt(0,0,0,0);return{setMask:function(Ae){se!==Ae&&!V&&(n.colorMask(Ae,Ae,Ae,Ae),se=Ae)},setLocked:function(Ae){V=Ae},setClear:function(Ae,ce,ze,Ne,lt){lt===!0&&(Ae*=Ne,ce*=Ne,ze*=Ne),be.set(Ae,ce,ze,Ne),Se.equals(be)===!1&&(n.clearColor(Ae,ce,ze,Ne),Se.copy(be))},reset:function(){V=!1,se=null,Se.set(-1,0,0,0)}}}function i(){let V=!1,be=!1,se=null,Se=null,Ae=null;return{setReversed:function(ce){if(be!==ce){let ze=e.get("EXT_clip_control");ce?ze.clipControlEXT(ze.LOWER_LEFT_EXT,ze.ZERO_TO_ONE_EXT):ze.clipControlEXT(ze.LOWER_LEFT_EXT,ze.NEGATIVE_ONE_TO_ONE_EXT),be=ce;let Ne=Ae;Ae=null,this.setClear(Ne)}},getReversed:function(){return be},setTest:function(ce){ce?he(n.DEPTH_TEST):Ve(n.DEPTH_TEST)},setMask:function(ce){se!==ce&&!V&&(n.depthMask(ce),se=ce)},setFunc:function(ce){if(be&&(ce=b_[ce]),Se!==ce){switch(ce){case qc:n.depthFunc(n.NEVER);break;case $c:n.depthFunc(n.ALWAYS);break;case Yc:n.depthFunc(n.LESS);break;case Hr:n.depthFunc(n.LEQUAL);break;case Zc:n.depthFunc(n.EQUAL);break;case Kc:n.depthFunc(n.GEQUAL);break;case Jc:n.depthFunc(n.GREATER);break;case jc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Se=ce}},setLocked:function(ce){V=ce},setClear:function(ce){Ae!==ce&&(Ae=ce,be&&(ce=1-ce),n.clearDepth(ce))},reset:function(){V=!1,se=null,Se=null,Ae=null,be=!1}}}function s(){let V=!1,be=null,se=null,Se=null,Ae=null,ce=null,ze=null,Ne=null,lt=null;return{setTest:function(ht){V||(ht?he(n.STENCIL_TEST):Ve(n.STENCIL_TEST))},setMask:function(ht){be!==ht&&!V&&(n.stencilMask(ht),be=ht)},setFunc:function(ht,Un,On){(se!==ht||Se!==Un||Ae!==On)&&(n.stencilFunc(ht,Un,On),se=ht,Se=Un,Ae=On)},setOp:function(ht,Un,On){(ce!==ht||ze!==Un||Ne!==On)&&(n.stencilOp(ht,Un,On),ce=ht,ze=Un,Ne=On)},setLocked:function(ht){V=ht},setClear:function(ht){lt!==ht&&(n.clearStencil(ht),lt=ht)},reset:function(){V=!1,be=null,se=null,Se=null,Ae=null,ce=null,ze=null,Ne=null,lt=null}}}let r=new t,o=new i,a=new s,l=new WeakMap,c=new WeakMap,u={},h={},d={},f=new WeakMap,p=[],_=null,g=!1,m=null,S=null,C=null,b=null,R=null,T=null,N=null,v=new pt(0,0,0),E=0,F=!1,I=null,U=null,k=null,X=null,O=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,ie=0,oe=n.getParameter(n.VERSION);oe.indexOf("WebGL")!==-1?(ie=parseFloat(/^WebGL (\d)/.exec(oe)[1]),H=ie>=1):oe.indexOf("OpenGL ES")!==-1&&(ie=parseFloat(/^OpenGL ES (\d)/.exec(oe)[1]),H=ie>=2);let le=null,de={},ue=n.getParameter(n.SCISSOR_BOX),_e=n.getParameter(n.VIEWPORT),st=new Qt().fromArray(ue),et=new Qt().fromArray(_e);function Q(V,be,se,Se){let Ae=new Uint8Array(4),ce=n.createTexture();n.bindTexture(V,ce),n.texParameteri(V,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(V,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let ze=0;ze<se;ze++)V===n.TEXTURE_3D||V===n.TEXTURE_2D_ARRAY?n.texImage3D(be,0,n.RGBA,1,1,Se,0,n.RGBA,n.UNSIGNED_BYTE,Ae):n.texImage2D(be+ze,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Ae);return ce}let ae={};ae[n.TEXTURE_2D]=Q(n.TEXTURE_2D,n.TEXTURE_2D,1),ae[n.TEXTURE_CUBE_MAP]=Q(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),ae[n.TEXTURE_2D_ARRAY]=Q(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),ae[n.TEXTURE_3D]=Q(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),he(n.DEPTH_TEST),o.setFunc(Hr),qt(!1),tn(vf),he(n.CULL_FACE),ct(fs);function he(V){u[V]!==!0&&(n.enable(V),u[V]=!0)}function Ve(V){u[V]!==!1&&(n.disable(V),u[V]=!1)}function De(V,be){return d[V]!==be?(n.bindFramebuffer(V,be),d[V]=be,V===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=be),V===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=be),!0):!1}function ke(V,be){let se=p,Se=!1;if(V){se=f.get(be),se===void 0&&(se=[],f.set(be,se));let Ae=V.textures;if(se.length!==Ae.length||se[0]!==n.COLOR_ATTACHMENT0){for(let ce=0,ze=Ae.length;ce<ze;ce++)se[ce]=n.COLOR_ATTACHMENT0+ce;se.length=Ae.length,Se=!0}}else se[0]!==n.BACK&&(se[0]=n.BACK,Se=!0);Se&&n.drawBuffers(se)}function Tt(V){return _!==V?(n.useProgram(V),_=V,!0):!1}let Ze={[nr]:n.FUNC_ADD,[W0]:n.FUNC_SUBTRACT,[X0]:n.FUNC_REVERSE_SUBTRACT};Ze[q0]=n.MIN,Ze[$0]=n.MAX;let mt={[Y0]:n.ZERO,[Z0]:n.ONE,[K0]:n.SRC_COLOR,[Wc]:n.SRC_ALPHA,[n_]:n.SRC_ALPHA_SATURATE,[e_]:n.DST_COLOR,[j0]:n.DST_ALPHA,[J0]:n.ONE_MINUS_SRC_COLOR,[Xc]:n.ONE_MINUS_SRC_ALPHA,[t_]:n.ONE_MINUS_DST_COLOR,[Q0]:n.ONE_MINUS_DST_ALPHA,[i_]:n.CONSTANT_COLOR,[s_]:n.ONE_MINUS_CONSTANT_COLOR,[r_]:n.CONSTANT_ALPHA,[o_]:n.ONE_MINUS_CONSTANT_ALPHA};function ct(V,be,se,Se,Ae,ce,ze,Ne,lt,ht){if(V===fs){g===!0&&(Ve(n.BLEND),g=!1);return}if(g===!1&&(he(n.BLEND),g=!0),V!==H0){if(V!==m||ht!==F){if((S!==nr||R!==nr)&&(n.blendEquation(n.FUNC_ADD),S=nr,R=nr),ht)switch(V){case Gr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case bf:n.blendFunc(n.ONE,n.ONE);break;case Mf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Sf:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Je("WebGLState: Invalid blending: ",V);break}else switch(V){case Gr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case bf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Mf:Je("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Sf:Je("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Je("WebGLState: Invalid blending: ",V);break}C=null,b=null,T=null,N=null,v.set(0,0,0),E=0,m=V,F=ht}return}Ae=Ae||be,ce=ce||se,ze=ze||Se,(be!==S||Ae!==R)&&(n.blendEquationSeparate(Ze[be],Ze[Ae]),S=be,R=Ae),(se!==C||Se!==b||ce!==T||ze!==N)&&(n.blendFuncSeparate(mt[se],mt[Se],mt[ce],mt[ze]),C=se,b=Se,T=ce,N=ze),(Ne.equals(v)===!1||lt!==E)&&(n.blendColor(Ne.r,Ne.g,Ne.b,lt),v.copy(Ne),E=lt),m=V,F=!1}function ot(V,be){V.side===$n?Ve(n.CULL_FACE):he(n.CULL_FACE);let se=V.side===oi;be&&(se=!se),qt(se),V.blending===Gr&&V.transparent===!1?ct(fs):ct(V.blending,V.blendEquation,V.blendSrc,V.blendDst,V.blendEquationAlpha,V.blendSrcAlpha,V.blendDstAlpha,V.blendColor,V.blendAlpha,V.premultipliedAlpha),o.setFunc(V.depthFunc),o.setTest(V.depthTest),o.setMask(V.depthWrite),r.setMask(V.colorWrite);let Se=V.stencilWrite;a.setTest(Se),Se&&(a.setMask(V.stencilWriteMask),a.setFunc(V.stencilFunc,V.stencilRef,V.stencilFuncMask),a.setOp(V.stencilFail,V.stencilZFail,V.stencilZPass)),bt(V.polygonOffset,V.polygonOffsetFactor,V.polygonOffsetUnits),V.alphaToCoverage===!0?he(n.SAMPLE_ALPHA_TO_COVERAGE):Ve(n.SAMPLE_ALPHA_TO_COVERAGE)}function qt(V){I!==V&&(V?n.frontFace(n.CW):n.frontFace(n.CCW),I=V)}function tn(V){V!==V0?(he(n.CULL_FACE),V!==U&&(V===vf?n.cullFace(n.BACK):V===z0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ve(n.CULL_FACE),U=V}function $t(V){V!==k&&(H&&n.lineWidth(V),k=V)}function bt(V,be,se){V?(he(n.POLYGON_OFFSET_FILL),(X!==be||O!==se)&&(X=be,O=se,o.getReversed()&&(be=-be),n.polygonOffset(be,se))):Ve(n.POLYGON_OFFSET_FILL)}function Ut(V){V?he(n.SCISSOR_TEST):Ve(n.SCISSOR_TEST)}function It(V){V===void 0&&(V=n.TEXTURE0+$-1),le!==V&&(n.activeTexture(V),le=V)}function G(V,be,se){se===void 0&&(le===null?se=n.TEXTURE0+$-1:se=le);let Se=de[se];Se===void 0&&(Se={type:void 0,texture:void 0},de[se]=Se),(Se.type!==V||Se.texture!==be)&&(le!==se&&(n.activeTexture(se),le=se),n.bindTexture(V,be||ae[V]),Se.type=V,Se.texture=be)}function We(){let V=de[le];V!==void 0&&V.type!==void 0&&(n.bindTexture(V.type,null),V.type=void 0,V.texture=void 0)}function fe(){try{n.compressedTexImage2D(...arguments)}catch(V){Je("WebGLState:",V)}}function P(){try{n.compressedTexImage3D(...arguments)}catch(V){Je("WebGLState:",V)}}function y(){try{n.texSubImage2D(...arguments)}catch(V){Je("WebGLState:",V)}}function q(){try{n.texSubImage3D(...arguments)}catch(V){Je("WebGLState:",V)}}function K(){try{n.compressedTexSubImage2D(...arguments)}catch(V){Je("WebGLState:",V)}}function ee(){try{n.compressedTexSubImage3D(...arguments)}catch(V){Je("WebGLState:",V)}}function me(){try{n.texStorage2D(...arguments)}catch(V){Je("WebGLState:",V)}}function ge(){try{n.texStorage3D(...arguments)}catch(V){Je("WebGLState:",V)}}function te(){try{n.texImage2D(...arguments)}catch(V){Je("WebGLState:",V)}}function ne(){try{n.texImage3D(...arguments)}catch(V){Je("WebGLState:",V)}}function xe(V){return h[V]!==void 0?h[V]:n.getParameter(V)}function Be(V,be){h[V]!==be&&(n.pixelStorei(V,be),h[V]=be)}function Me(V){st.equals(V)===!1&&(n.scissor(V.x,V.y,V.z,V.w),st.copy(V))}function ve(V){et.equals(V)===!1&&(n.viewport(V.x,V.y,V.z,V.w),et.copy(V))}function Oe(V,be){let se=c.get(be);se===void 0&&(se=new WeakMap,c.set(be,se));let Se=se.get(V);Se===void 0&&(Se=n.getUniformBlockIndex(be,V.name),se.set(V,Se))}function Xe(V,be){let Se=c.get(be).get(V);l.get(be)!==Se&&(n.uniformBlockBinding(be,Se,V.__bindingPointIndex),l.set(be,Se))}function qe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},le=null,de={},d={},f=new WeakMap,p=[],_=null,g=!1,m=null,S=null,C=null,b=null,R=null,T=null,N=null,v=new pt(0,0,0),E=0,F=!1,I=null,U=null,k=null,X=null,O=null,st.set(0,0,n.canvas.width,n.canvas.height),et.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:he,disable:Ve,bindFramebuffer:De,drawBuffers:ke,useProgram:Tt,setBlending:ct,setMaterial:ot,setFlipSided:qt,setCullFace:tn,setLineWidth:$t,setPolygonOffset:bt,setScissorTest:Ut,activeTexture:It,bindTexture:G,unbindTexture:We,compressedTexImage2D:fe,compressedTexImage3D:P,texImage2D:te,texImage3D:ne,pixelStorei:Be,getParameter:xe,updateUBOMapping:Oe,uniformBlockBinding:Xe,texStorage2D:me,texStorage3D:ge,texSubImage2D:y,texSubImage3D:q,compressedTexSubImage2D:K,compressedTexSubImage3D:ee,scissor:Me,viewport:ve,reset:qe}}function eA(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new je,u=new WeakMap,h=new Set,d,f=new WeakMap,p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(P,y){return p?new OffscreenCanvas(P,y):za("canvas")}function g(P,y,q){let K=1,ee=fe(P);if((ee.width>q||ee.height>q)&&(K=q/Math.max(ee.width,ee.height)),K<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let me=Math.floor(K*ee.width),ge=Math.floor(K*ee.height);d===void 0&&(d=_(me,ge));let te=y?_(me,ge):d;return te.width=me,te.height=ge,te.getContext("2d").drawImage(P,0,0,me,ge),$e("WebGLRenderer: Texture has been resized from ("+ee.width+"x"+ee.height+") to ("+me+"x"+ge+")."),te}else return"data"in P&&$e("WebGLRenderer: Image in DataTexture is too big ("+ee.width+"x"+ee.height+")."),P;return P}function m(P){return P.generateMipmaps}function S(P){n.generateMipmap(P)}function C(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function b(P,y,q,K,ee,me=!1){if(P!==null){if(n[P]!==void 0)return n[P];$e("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let ge;K&&(ge=e.get("EXT_texture_norm16"),ge||$e("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=y;if(y===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&ge&&(te=ge.R16_EXT),q===n.SHORT&&ge&&(te=ge.R16_SNORM_EXT)),y===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),y===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&ge&&(te=ge.RG16_EXT),q===n.SHORT&&ge&&(te=ge.RG16_SNORM_EXT)),y===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),y===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),y===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),y===n.RGB&&(q===n.UNSIGNED_SHORT&&ge&&(te=ge.RGB16_EXT),q===n.SHORT&&ge&&(te=ge.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),y===n.RGBA){let ne=me?Ba:xt.getTransfer(ee);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=ne===Dt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&ge&&(te=ge.RGBA16_EXT),q===n.SHORT&&ge&&(te=ge.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function R(P,y){let q;return P?y===null||y===ts||y===Jo?q=n.DEPTH24_STENCIL8:y===Pi?q=n.DEPTH32F_STENCIL8:y===Ko&&(q=n.DEPTH24_STENCIL8,$e("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===ts||y===Jo?q=n.DEPTH_COMPONENT24:y===Pi?q=n.DEPTH_COMPONENT32F:y===Ko&&(q=n.DEPTH_COMPONENT16),q}function T(P,y){return m(P)===!0||P.isFramebufferTexture&&P.minFilter!==vn&&P.minFilter!==En?Math.log2(Math.max(y.width,y.height))+1:P.mipmaps!==void 0&&P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?y.mipmaps.length:1}function N(P){let y=P.target;y.removeEventListener("dispose",N),E(y),y.isVideoTexture&&u.delete(y),y.isHTMLTexture&&h.delete(y)}function v(P){let y=P.target;y.removeEventListener("dispose",v),I(y)}function E(P){let y=i.get(P);if(y.__webglInit===void 0)return;let q=P.source,K=f.get(q);if(K){let ee=K[y.__cacheKey];ee.usedTimes--,ee.usedTimes===0&&F(P),Object.keys(K).length===0&&f.delete(q)}i.remove(P)}function F(P){let y=i.get(P);n.deleteTexture(y.__webglTexture);let q=P.source,K=f.get(q);delete K[y.__cacheKey],o.memory.textures--}function I(P){let y=i.get(P);if(P.depthTexture&&(P.depthTexture.dispose(),i.remove(P.depthTexture)),P.isWebGLCubeRenderTarget)for(let K=0;K<6;K++){if(Array.isArray(y.__webglFramebuffer[K]))for(let ee=0;ee<y.__webglFramebuffer[K].length;ee++)n.deleteFramebuffer(y.__webglFramebuffer[K][ee]);else n.deleteFramebuffer(y.__webglFramebuffer[K]);y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer[K])}else{if(Array.isArray(y.__webglFramebuffer))for(let K=0;K<y.__webglFramebuffer.length;K++)n.deleteFramebuffer(y.__webglFramebuffer[K]);else n.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&n.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let K=0;K<y.__webglColorRenderbuffer.length;K++)y.__webglColorRenderbuffer[K]&&n.deleteRenderbuffer(y.__webglColorRenderbuffer[K]);y.__webglDepthRenderbuffer&&n.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let q=P.textures;for(let K=0,ee=q.length;K<ee;K++){let me=i.get(q[K]);me.__webglTexture&&(n.deleteTexture(me.__webglTexture),o.memory.textures--),i.remove(q[K])}i.remove(P)}let U=0;function k(){U=0}function X(){return U}function O(P){U=P}function $(){let P=U;return P>=s.maxTextures&&$e("WebGLTextures: Trying to use "+P+" texture units while this GPU supports only "+s.maxTextures),U+=1,P}function H(P){let y=[];return y.push(P.wrapS),y.push(P.wrapT),y.push(P.wrapR||0),y.push(P.magFilter),y.push(P.minFilter),y.push(P.anisotropy),y.push(P.internalFormat),y.push(P.format),y.push(P.type),y.push(P.generateMipmaps),y.push(P.premultiplyAlpha),y.push(P.flipY),y.push(P.unpackAlignment),y.push(P.colorSpace),y.join()}function ie(P,y){let q=i.get(P);if(P.isVideoTexture&&G(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&q.__version!==P.version){let K=P.image;if(K===null)$e("WebGLRenderer: Texture marked for update but no image data found.");else if(K.complete===!1)$e("WebGLRenderer: Texture marked for update but image is incomplete");else{Ve(q,P,y);return}}else P.isExternalTexture&&(q.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+y)}function oe(P,y){let q=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&q.__version!==P.version){Ve(q,P,y);return}else P.isExternalTexture&&(q.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+y)}function le(P,y){let q=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&q.__version!==P.version){Ve(q,P,y);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+y)}function de(P,y){let q=i.get(P);if(P.isCubeDepthTexture!==!0&&P.version>0&&q.__version!==P.version){De(q,P,y);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+y)}let ue={[Qc]:n.REPEAT,[us]:n.CLAMP_TO_EDGE,[eu]:n.MIRRORED_REPEAT},_e={[vn]:n.NEAREST,[c_]:n.NEAREST_MIPMAP_NEAREST,[al]:n.NEAREST_MIPMAP_LINEAR,[En]:n.LINEAR,[Eu]:n.LINEAR_MIPMAP_NEAREST,[fr]:n.LINEAR_MIPMAP_LINEAR},st={[d_]:n.NEVER,[__]:n.ALWAYS,[f_]:n.LESS,[ch]:n.LEQUAL,[p_]:n.EQUAL,[uh]:n.GEQUAL,[m_]:n.GREATER,[g_]:n.NOTEQUAL};function et(P,y){if(y.type===Pi&&e.has("OES_texture_float_linear")===!1&&(y.magFilter===En||y.magFilter===Eu||y.magFilter===al||y.magFilter===fr||y.minFilter===En||y.minFilter===Eu||y.minFilter===al||y.minFilter===fr)&&$e("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,ue[y.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,ue[y.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,ue[y.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,_e[y.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,_e[y.minFilter]),y.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,st[y.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===vn||y.minFilter!==al&&y.minFilter!==fr||y.type===Pi&&e.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||i.get(y).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(P,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),i.get(y).__currentAnisotropy=y.anisotropy}}}function Q(P,y){let q=!1;P.__webglInit===void 0&&(P.__webglInit=!0,y.addEventListener("dispose",N));let K=y.source,ee=f.get(K);ee===void 0&&(ee={},f.set(K,ee));let me=H(y);if(me!==P.__cacheKey){ee[me]===void 0&&(ee[me]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ee[me].usedTimes++;let ge=ee[P.__cacheKey];ge!==void 0&&(ee[P.__cacheKey].usedTimes--,ge.usedTimes===0&&F(y)),P.__cacheKey=me,P.__webglTexture=ee[me].texture}return q}function ae(P,y,q){return Math.floor(Math.floor(P/q)/y)}function he(P,y,q,K){let me=P.updateRanges;if(me.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,y.width,y.height,q,K,y.data);else{me.sort((Be,Me)=>Be.start-Me.start);let ge=0;for(let Be=1;Be<me.length;Be++){let Me=me[ge],ve=me[Be],Oe=Me.start+Me.count,Xe=ae(ve.start,y.width,4),qe=ae(Me.start,y.width,4);ve.start<=Oe+1&&Xe===qe&&ae(ve.start+ve.count-1,y.width,4)===Xe?Me.count=Math.max(Me.count,ve.start+ve.count-Me.start):(++ge,me[ge]=ve)}me.length=ge+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),ne=t.getParameter(n.UNPACK_SKIP_PIXELS),xe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,y.width);for(let Be=0,Me=me.length;Be<Me;Be++){let ve=me[Be],Oe=Math.floor(ve.start/4),Xe=Math.ceil(ve.count/4),qe=Oe%y.width,V=Math.floor(Oe/y.width),be=Xe,se=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,qe),t.pixelStorei(n.UNPACK_SKIP_ROWS,V),t.texSubImage2D(n.TEXTURE_2D,0,qe,V,be,se,q,K,y.data)}P.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ne),t.pixelStorei(n.UNPACK_SKIP_ROWS,xe)}}function Ve(P,y,q){let K=n.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(K=n.TEXTURE_2D_ARRAY),y.isData3DTexture&&(K=n.TEXTURE_3D);let ee=Q(P,y),me=y.source;t.bindTexture(K,P.__webglTexture,n.TEXTURE0+q);let ge=i.get(me);if(me.version!==ge.__version||ee===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&y.image instanceof ImageBitmap)===!1){let se=xt.getPrimaries(xt.workingColorSpace),Se=y.colorSpace===Ns?null:xt.getPrimaries(y.colorSpace),Ae=y.colorSpace===Ns||se===Se?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ae)}t.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment);let ne=g(y.image,!1,s.maxTextureSize);ne=We(y,ne);let xe=r.convert(y.format,y.colorSpace),Be=r.convert(y.type),Me=b(y.internalFormat,xe,Be,y.normalized,y.colorSpace,y.isVideoTexture);et(K,y);let ve,Oe=y.mipmaps,Xe=y.isVideoTexture!==!0,qe=ge.__version===void 0||ee===!0,V=me.dataReady,be=T(y,ne);if(y.isDepthTexture)Me=R(y.format===pr,y.type),qe&&(Xe?t.texStorage2D(n.TEXTURE_2D,1,Me,ne.width,ne.height):t.texImage2D(n.TEXTURE_2D,0,Me,ne.width,ne.height,0,xe,Be,null));else if(y.isDataTexture)if(Oe.length>0){Xe&&qe&&t.texStorage2D(n.TEXTURE_2D,be,Me,Oe[0].width,Oe[0].height);for(let se=0,Se=Oe.length;se<Se;se++)ve=Oe[se],Xe?V&&t.texSubImage2D(n.TEXTURE_2D,se,0,0,ve.width,ve.height,xe,Be,ve.data):t.texImage2D(n.TEXTURE_2D,se,Me,ve.width,ve.height,0,xe,Be,ve.data);y.generateMipmaps=!1}else Xe?(qe&&t.texStorage2D(n.TEXTURE_2D,be,Me,ne.width,ne.height),V&&he(y,ne,xe,Be)):t.texImage2D(n.TEXTURE_2D,0,Me,ne.width,ne.height,0,xe,Be,ne.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){Xe&&qe&&t.texStorage3D(n.TEXTURE_2D_ARRAY,be,Me,Oe[0].width,Oe[0].height,ne.depth);for(let se=0,Se=Oe.length;se<Se;se++)if(ve=Oe[se],y.format!==ai)if(xe!==null)if(Xe){if(V)if(y.layerUpdates.size>0){let Ae=Yf(ve.width,ve.height,y.format,y.type);for(let ce of y.layerUpdates){let ze=ve.data.subarray(ce*Ae/ve.data.BYTES_PER_ELEMENT,(ce+1)*Ae/ve.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,se,0,0,ce,ve.width,ve.height,1,xe,ze)}y.clearLayerUpdates()}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,se,0,0,0,ve.width,ve.height,ne.depth,xe,ve.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,se,Me,ve.width,ve.height,ne.depth,0,ve.data,0,0);else $e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Xe?V&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,se,0,0,0,ve.width,ve.height,ne.depth,xe,Be,ve.data):t.texImage3D(n.TEXTURE_2D_ARRAY,se,Me,ve.width,ve.height,ne.depth,0,xe,Be,ve.data)}else{Xe&&qe&&t.texStorage2D(n.TEXTURE_2D,be,Me,Oe[0].width,Oe[0].height);for(let se=0,Se=Oe.length;se<Se;se++)ve=Oe[se],y.format!==ai?xe!==null?Xe?V&&t.compressedTexSubImage2D(n.TEXTURE_2D,se,0,0,ve.width,ve.height,xe,ve.data):t.compressedTexImage2D(n.TEXTURE_2D,se,Me,ve.width,ve.height,0,ve.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Xe?V&&t.texSubImage2D(n.TEXTURE_2D,se,0,0,ve.width,ve.height,xe,Be,ve.data):t.texImage2D(n.TEXTURE_2D,se,Me,ve.width,ve.height,0,xe,Be,ve.data)}else if(y.isDataArrayTexture)if(Xe){if(qe&&t.texStorage3D(n.TEXTURE_2D_ARRAY,be,Me,ne.width,ne.height,ne.depth),V)if(y.layerUpdates.size>0){let se=Yf(ne.width,ne.height,y.format,y.type);for(let Se of y.layerUpdates){let Ae=ne.data.subarray(Se*se/ne.data.BYTES_PER_ELEMENT,(Se+1)*se/ne.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Se,ne.width,ne.height,1,xe,Be,Ae)}y.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ne.width,ne.height,ne.depth,xe,Be,ne.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,Me,ne.width,ne.height,ne.depth,0,xe,Be,ne.data);else if(y.isData3DTexture)Xe?(qe&&t.texStorage3D(n.TEXTURE_3D,be,Me,ne.width,ne.height,ne.depth),V&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ne.width,ne.height,ne.depth,xe,Be,ne.data)):t.texImage3D(n.TEXTURE_3D,0,Me,ne.width,ne.height,ne.depth,0,xe,Be,ne.data);else if(y.isFramebufferTexture){if(qe)if(Xe)t.texStorage2D(n.TEXTURE_2D,be,Me,ne.width,ne.height);else{let se=ne.width,Se=ne.height;for(let Ae=0;Ae<be;Ae++)t.texImage2D(n.TEXTURE_2D,Ae,Me,se,Se,0,xe,Be,null),se>>=1,Se>>=1}}else if(y.isHTMLTexture){if("texElementImage2D"in n){let se=n.canvas;if(se.hasAttribute("layoutsubtree")||se.setAttribute("layoutsubtree","true"),ne.parentNode!==se){se.appendChild(ne),h.add(y),se.onpaint=Se=>{let Ae=Se.changedElements;for(let ce of h)Ae.includes(ce.image)&&(ce.needsUpdate=!0)},se.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ne);else{let Ae=n.RGBA,ce=n.RGBA,ze=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Ae,ce,ze,ne)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Oe.length>0){if(Xe&&qe){let se=fe(Oe[0]);t.texStorage2D(n.TEXTURE_2D,be,Me,se.width,se.height)}for(let se=0,Se=Oe.length;se<Se;se++)ve=Oe[se],Xe?V&&t.texSubImage2D(n.TEXTURE_2D,se,0,0,xe,Be,ve):t.texImage2D(n.TEXTURE_2D,se,Me,xe,Be,ve);y.generateMipmaps=!1}else if(Xe){if(qe){let se=fe(ne);t.texStorage2D(n.TEXTURE_2D,be,Me,se.width,se.height)}V&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,xe,Be,ne)}else t.texImage2D(n.TEXTURE_2D,0,Me,xe,Be,ne);m(y)&&S(K),ge.__version=me.version,y.onUpdate&&y.onUpdate(y)}P.__version=y.version}function De(P,y,q){if(y.image.length!==6)return;let K=Q(P,y),ee=y.source;t.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+q);let me=i.get(ee);if(ee.version!==me.__version||K===!0){t.activeTexture(n.TEXTURE0+q);let ge=xt.getPrimaries(xt.workingColorSpace),te=y.colorSpace===Ns?null:xt.getPrimaries(y.colorSpace),ne=y.colorSpace===Ns||ge===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne);let xe=y.isCompressedTexture||y.image[0].isCompressedTexture,Be=y.image[0]&&y.image[0].isDataTexture,Me=[];for(let ce=0;ce<6;ce++)!xe&&!Be?Me[ce]=g(y.image[ce],!0,s.maxCubemapSize):Me[ce]=Be?y.image[ce].image:y.image[ce],Me[ce]=We(y,Me[ce]);let ve=Me[0],Oe=r.convert(y.format,y.colorSpace),Xe=r.convert(y.type),qe=b(y.internalFormat,Oe,Xe,y.normalized,y.colorSpace),V=y.isVideoTexture!==!0,be=me.__version===void 0||K===!0,se=ee.dataReady,Se=T(y,ve);et(n.TEXTURE_CUBE_MAP,y);let Ae;if(xe){V&&be&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Se,qe,ve.width,ve.height);for(let ce=0;ce<6;ce++){Ae=Me[ce].mipmaps;for(let ze=0;ze<Ae.length;ze++){let Ne=Ae[ze];y.format!==ai?Oe!==null?V?se&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze,0,0,Ne.width,Ne.height,Oe,Ne.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze,qe,Ne.width,Ne.height,0,Ne.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):V?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze,0,0,Ne.width,Ne.height,Oe,Xe,Ne.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze,qe,Ne.width,Ne.height,0,Oe,Xe,Ne.data)}}}else{if(Ae=y.mipmaps,V&&be){Ae.length>0&&Se++;let ce=fe(Me[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Se,qe,ce.width,ce.height)}for(let ce=0;ce<6;ce++)if(Be){V?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,0,0,0,Me[ce].width,Me[ce].height,Oe,Xe,Me[ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,0,qe,Me[ce].width,Me[ce].height,0,Oe,Xe,Me[ce].data);for(let ze=0;ze<Ae.length;ze++){let lt=Ae[ze].image[ce].image;V?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze+1,0,0,lt.width,lt.height,Oe,Xe,lt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze+1,qe,lt.width,lt.height,0,Oe,Xe,lt.data)}}else{V?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,0,0,0,Oe,Xe,Me[ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,0,qe,Oe,Xe,Me[ce]);for(let ze=0;ze<Ae.length;ze++){let Ne=Ae[ze];V?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze+1,0,0,Oe,Xe,Ne.image[ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze+1,qe,Oe,Xe,Ne.image[ce])}}}m(y)&&S(n.TEXTURE_CUBE_MAP),me.__version=ee.version,y.onUpdate&&y.onUpdate(y)}P.__version=y.version}function ke(P,y,q,K,ee,me){let ge=r.convert(q.format,q.colorSpace),te=r.convert(q.type),ne=b(q.internalFormat,ge,te,q.normalized,q.colorSpace),xe=i.get(y),Be=i.get(q);if(Be.__renderTarget=y,!xe.__hasExternalTextures){let Me=Math.max(1,y.width>>me),ve=Math.max(1,y.height>>me);ee===n.TEXTURE_3D||ee===n.TEXTURE_2D_ARRAY?t.texImage3D(ee,me,ne,Me,ve,y.depth,0,ge,te,null):t.texImage2D(ee,me,ne,Me,ve,0,ge,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,P),It(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,K,ee,Be.__webglTexture,0,Ut(y)):(ee===n.TEXTURE_2D||ee>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ee<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,K,ee,Be.__webglTexture,me),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Tt(P,y,q){if(n.bindRenderbuffer(n.RENDERBUFFER,P),y.depthBuffer){let K=y.depthTexture,ee=K&&K.isDepthTexture?K.type:null,me=R(y.stencilBuffer,ee),ge=y.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;It(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Ut(y),me,y.width,y.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,Ut(y),me,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,me,y.width,y.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ge,n.RENDERBUFFER,P)}else{let K=y.textures;for(let ee=0;ee<K.length;ee++){let me=K[ee],ge=r.convert(me.format,me.colorSpace),te=r.convert(me.type),ne=b(me.internalFormat,ge,te,me.normalized,me.colorSpace);It(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Ut(y),ne,y.width,y.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,Ut(y),ne,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,ne,y.width,y.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Ze(P,y,q){let K=y.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,P),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ee=i.get(y.depthTexture);if(ee.__renderTarget=y,(!ee.__webglTexture||y.depthTexture.image.width!==y.width||y.depthTexture.image.height!==y.height)&&(y.depthTexture.image.width=y.width,y.depthTexture.image.height=y.height,y.depthTexture.needsUpdate=!0),K){if(ee.__webglInit===void 0&&(ee.__webglInit=!0,y.depthTexture.addEventListener("dispose",N)),ee.__webglTexture===void 0){ee.__webglTexture=n.createTexture(),t.bindTexture(n.TEXTURE_CUBE_MAP,ee.__webglTexture),et(n.TEXTURE_CUBE_MAP,y.depthTexture);let xe=r.convert(y.depthTexture.format),Be=r.convert(y.depthTexture.type),Me;y.depthTexture.format===hs?Me=n.DEPTH_COMPONENT24:y.depthTexture.format===pr&&(Me=n.DEPTH24_STENCIL8);for(let ve=0;ve<6;ve++)n.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ve,0,Me,y.width,y.height,0,xe,Be,null)}}else ie(y.depthTexture,0);let me=ee.__webglTexture,ge=Ut(y),te=K?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,ne=y.depthTexture.format===pr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(y.depthTexture.format===hs)It(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ne,te,me,0,ge):n.framebufferTexture2D(n.FRAMEBUFFER,ne,te,me,0);else if(y.depthTexture.format===pr)It(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ne,te,me,0,ge):n.framebufferTexture2D(n.FRAMEBUFFER,ne,te,me,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function mt(P){let y=i.get(P),q=P.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==P.depthTexture){let K=P.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),K){let ee=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,K.removeEventListener("dispose",ee)};K.addEventListener("dispose",ee),y.__depthDisposeCallback=ee}y.__boundDepthTexture=K}if(P.depthTexture&&!y.__autoAllocateDepthBuffer)if(q)for(let K=0;K<6;K++)Ze(y.__webglFramebuffer[K],P,K);else{let K=P.texture.mipmaps;K&&K.length>0?Ze(y.__webglFramebuffer[0],P,0):Ze(y.__webglFramebuffer,P,0)}else if(q){y.__webglDepthbuffer=[];for(let K=0;K<6;K++)if(t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[K]),y.__webglDepthbuffer[K]===void 0)y.__webglDepthbuffer[K]=n.createRenderbuffer(),Tt(y.__webglDepthbuffer[K],P,!1);else{let ee=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,me=y.__webglDepthbuffer[K];n.bindRenderbuffer(n.RENDERBUFFER,me),n.framebufferRenderbuffer(n.FRAMEBUFFER,ee,n.RENDERBUFFER,me)}}else{let K=P.texture.mipmaps;if(K&&K.length>0?t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=n.createRenderbuffer(),Tt(y.__webglDepthbuffer,P,!1);else{let ee=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,me=y.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,me),n.framebufferRenderbuffer(n.FRAMEBUFFER,ee,n.RENDERBUFFER,me)}}t.bindFramebuffer(n.FRAMEBUFFER,null)}function ct(P,y,q){let K=i.get(P);y!==void 0&&ke(K.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&mt(P)}function ot(P){let y=P.texture,q=i.get(P),K=i.get(y);P.addEventListener("dispose",v);let ee=P.textures,me=P.isWebGLCubeRenderTarget===!0,ge=ee.length>1;if(ge||(K.__webglTexture===void 0&&(K.__webglTexture=n.createTexture()),K.__version=y.version,o.memory.textures++),me){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(y.mipmaps&&y.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let ne=0;ne<y.mipmaps.length;ne++)q.__webglFramebuffer[te][ne]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(y.mipmaps&&y.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<y.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(ge)for(let te=0,ne=ee.length;te<ne;te++){let xe=i.get(ee[te]);xe.__webglTexture===void 0&&(xe.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&It(P)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<ee.length;te++){let ne=ee[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let xe=r.convert(ne.format,ne.colorSpace),Be=r.convert(ne.type),Me=b(ne.internalFormat,xe,Be,ne.normalized,ne.colorSpace,P.isXRRenderTarget===!0),ve=Ut(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,ve,Me,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),Tt(q.__webglDepthRenderbuffer,P,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(me){t.bindTexture(n.TEXTURE_CUBE_MAP,K.__webglTexture),et(n.TEXTURE_CUBE_MAP,y);for(let te=0;te<6;te++)if(y.mipmaps&&y.mipmaps.length>0)for(let ne=0;ne<y.mipmaps.length;ne++)ke(q.__webglFramebuffer[te][ne],P,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,ne);else ke(q.__webglFramebuffer[te],P,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);m(y)&&S(n.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(ge){for(let te=0,ne=ee.length;te<ne;te++){let xe=ee[te],Be=i.get(xe),Me=n.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(Me=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(Me,Be.__webglTexture),et(Me,xe),ke(q.__webglFramebuffer,P,xe,n.COLOR_ATTACHMENT0+te,Me,0),m(xe)&&S(Me)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(te=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,K.__webglTexture),et(te,y),y.mipmaps&&y.mipmaps.length>0)for(let ne=0;ne<y.mipmaps.length;ne++)ke(q.__webglFramebuffer[ne],P,y,n.COLOR_ATTACHMENT0,te,ne);else ke(q.__webglFramebuffer,P,y,n.COLOR_ATTACHMENT0,te,0);m(y)&&S(te),t.unbindTexture()}P.depthBuffer&&mt(P)}function qt(P){let y=P.textures;for(let q=0,K=y.length;q<K;q++){let ee=y[q];if(m(ee)){let me=C(P),ge=i.get(ee).__webglTexture;t.bindTexture(me,ge),S(me),t.unbindTexture()}}}let tn=[],$t=[];function bt(P){if(P.samples>0){if(It(P)===!1){let y=P.textures,q=P.width,K=P.height,ee=n.COLOR_BUFFER_BIT,me=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ge=i.get(P),te=y.length>1;if(te)for(let xe=0;xe<y.length;xe++)t.bindFramebuffer(n.FRAMEBUFFER,ge.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ge.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ge.__webglMultisampledFramebuffer);let ne=P.texture.mipmaps;ne&&ne.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ge.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ge.__webglFramebuffer);for(let xe=0;xe<y.length;xe++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(ee|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(ee|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ge.__webglColorRenderbuffer[xe]);let Be=i.get(y[xe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,Be,0)}n.blitFramebuffer(0,0,q,K,0,0,q,K,ee,n.NEAREST),l===!0&&(tn.length=0,$t.length=0,tn.push(n.COLOR_ATTACHMENT0+xe),P.depthBuffer&&P.resolveDepthBuffer===!1&&(tn.push(me),$t.push(me),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,$t)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,tn))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let xe=0;xe<y.length;xe++){t.bindFramebuffer(n.FRAMEBUFFER,ge.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.RENDERBUFFER,ge.__webglColorRenderbuffer[xe]);let Be=i.get(y[xe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ge.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.TEXTURE_2D,Be,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ge.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.resolveDepthBuffer===!1&&l){let y=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[y])}}}function Ut(P){return Math.min(s.maxSamples,P.samples)}function It(P){let y=i.get(P);return P.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function G(P){let y=o.render.frame;u.get(P)!==y&&(u.set(P,y),P.update())}function We(P,y){let q=P.colorSpace,K=P.format,ee=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||q!==ka&&q!==Ns&&(xt.getTransfer(q)===Dt?(K!==ai||ee!==Ri)&&$e("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Je("WebGLTextures: Unsupported texture color space:",q)),y}function fe(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=$,this.resetTextureUnits=k,this.getTextureUnits=X,this.setTextureUnits=O,this.setTexture2D=ie,this.setTexture2DArray=oe,this.setTexture3D=le,this.setTextureCube=de,this.rebindTextures=ct,this.setupRenderTarget=ot,this.updateRenderTargetMipmap=qt,this.updateMultisampleRenderTarget=bt,this.setupDepthRenderbuffer=mt,this.setupFrameBufferTexture=ke,this.useMultisampledRTT=It,this.isReversedDepthBuffer=function(){return t.buffers.depth.getReversed()}}function tA(n,e){function t(i,s=Ns){let r,o=xt.getTransfer(s);if(i===Ri)return n.UNSIGNED_BYTE;if(i===Cu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Ru)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Ff)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Uf)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Nf)return n.BYTE;if(i===Df)return n.SHORT;if(i===Ko)return n.UNSIGNED_SHORT;if(i===Au)return n.INT;if(i===ts)return n.UNSIGNED_INT;if(i===Pi)return n.FLOAT;if(i===ps)return n.HALF_FLOAT;if(i===Of)return n.ALPHA;if(i===kf)return n.RGB;if(i===ai)return n.RGBA;if(i===hs)return n.DEPTH_COMPONENT;if(i===pr)return n.DEPTH_STENCIL;if(i===Bf)return n.RED;if(i===Pu)return n.RED_INTEGER;if(i===mr)return n.RG;if(i===Iu)return n.RG_INTEGER;if(i===Lu)return n.RGBA_INTEGER;if(i===ll||i===cl||i===ul||i===hl)if(o===Dt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===ll)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===cl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===ul)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===hl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===ll)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===cl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===ul)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===hl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Nu||i===Du||i===Fu||i===Uu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Nu)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Du)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Fu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Uu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Ou||i===ku||i===Bu||i===Vu||i===zu||i===dl||i===Gu)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Ou||i===ku)return o===Dt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Bu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Vu)return r.COMPRESSED_R11_EAC;if(i===zu)return r.COMPRESSED_SIGNED_R11_EAC;if(i===dl)return r.COMPRESSED_RG11_EAC;if(i===Gu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Hu||i===Wu||i===Xu||i===qu||i===$u||i===Yu||i===Zu||i===Ku||i===Ju||i===ju||i===Qu||i===eh||i===th||i===nh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Hu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Wu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Xu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===qu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===$u)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Yu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Zu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Ku)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Ju)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===ju)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Qu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===eh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===th)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===nh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===ih||i===sh||i===rh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===ih)return o===Dt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===sh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===rh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===oh||i===ah||i===fl||i===lh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===oh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===ah)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===fl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===lh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Jo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var nA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,iA=`
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

}`,lp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new ja(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new en({vertexShader:nA,fragmentShader:iA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new wt(new Xr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},cp=class extends Qi{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,p=null,_=typeof XRWebGLBinding<"u",g=new lp,m={},S=t.getContextAttributes(),C=null,b=null,R=[],T=[],N=new je,v=null,E=new Xn;E.viewport=new Qt;let F=new Xn;F.viewport=new Qt;let I=[E,F],U=new Su,k=null,X=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let ae=R[Q];return ae===void 0&&(ae=new Xo,R[Q]=ae),ae.getTargetRaySpace()},this.getControllerGrip=function(Q){let ae=R[Q];return ae===void 0&&(ae=new Xo,R[Q]=ae),ae.getGripSpace()},this.getHand=function(Q){let ae=R[Q];return ae===void 0&&(ae=new Xo,R[Q]=ae),ae.getHandSpace()};function O(Q){let ae=T.indexOf(Q.inputSource);if(ae===-1)return;let he=R[ae];he!==void 0&&(he.update(Q.inputSource,Q.frame,c||o),he.dispatchEvent({type:Q.type,data:Q.inputSource}))}function $(){s.removeEventListener("select",O),s.removeEventListener("selectstart",O),s.removeEventListener("selectend",O),s.removeEventListener("squeeze",O),s.removeEventListener("squeezestart",O),s.removeEventListener("squeezeend",O),s.removeEventListener("end",$),s.removeEventListener("inputsourceschange",H);for(let Q=0;Q<R.length;Q++){let ae=T[Q];ae!==null&&(T[Q]=null,R[Q].disconnect(ae))}k=null,X=null,g.reset();for(let Q in m)delete m[Q];e.setRenderTarget(C),f=null,d=null,h=null,s=null,b=null,et.stop(),i.isPresenting=!1,e.setPixelRatio(v),e.setSize(N.width,N.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,i.isPresenting===!0&&$e("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,i.isPresenting===!0&&$e("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&_&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(C=e.getRenderTarget(),s.addEventListener("select",O),s.addEventListener("selectstart",O),s.addEventListener("selectend",O),s.addEventListener("squeeze",O),s.addEventListener("squeezestart",O),s.addEventListener("squeezeend",O),s.addEventListener("end",$),s.addEventListener("inputsourceschange",H),S.xrCompatible!==!0&&await t.makeXRCompatible(),v=e.getPixelRatio(),e.getSize(N),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let he=null,Ve=null,De=null;S.depth&&(De=S.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,he=S.stencil?pr:hs,Ve=S.stencil?Jo:ts);let ke={colorFormat:t.RGBA8,depthFormat:De,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(ke),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),b=new Ai(d.textureWidth,d.textureHeight,{format:ai,type:Ri,depthTexture:new Is(d.textureWidth,d.textureHeight,Ve,void 0,void 0,void 0,void 0,void 0,void 0,he),stencilBuffer:S.stencil,colorSpace:e.outputColorSpace,samples:S.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1})}else{let he={antialias:S.antialias,alpha:!0,depth:S.depth,stencil:S.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,he),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new Ai(f.framebufferWidth,f.framebufferHeight,{format:ai,type:Ri,colorSpace:e.outputColorSpace,stencilBuffer:S.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),et.setContext(s),et.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function H(Q){for(let ae=0;ae<Q.removed.length;ae++){let he=Q.removed[ae],Ve=T.indexOf(he);Ve>=0&&(T[Ve]=null,R[Ve].disconnect(he))}for(let ae=0;ae<Q.added.length;ae++){let he=Q.added[ae],Ve=T.indexOf(he);if(Ve===-1){for(let ke=0;ke<R.length;ke++)if(ke>=T.length){T.push(he),Ve=ke;break}else if(T[ke]===null){T[ke]=he,Ve=ke;break}if(Ve===-1)break}let De=R[Ve];De&&De.connect(he)}}let ie=new z,oe=new z;function le(Q,ae,he){ie.setFromMatrixPosition(ae.matrixWorld),oe.setFromMatrixPosition(he.matrixWorld);let Ve=ie.distanceTo(oe),De=ae.projectionMatrix.elements,ke=he.projectionMatrix.elements,Tt=De[14]/(De[10]-1),Ze=De[14]/(De[10]+1),mt=(De[9]+1)/De[5],ct=(De[9]-1)/De[5],ot=(De[8]-1)/De[0],qt=(ke[8]+1)/ke[0],tn=Tt*ot,$t=Tt*qt,bt=Ve/(-ot+qt),Ut=bt*-ot;if(ae.matrixWorld.decompose(Q.position,Q.quaternion,Q.scale),Q.translateX(Ut),Q.translateZ(bt),Q.matrixWorld.compose(Q.position,Q.quaternion,Q.scale),Q.matrixWorldInverse.copy(Q.matrixWorld).invert(),De[10]===-1)Q.projectionMatrix.copy(ae.projectionMatrix),Q.projectionMatrixInverse.copy(ae.projectionMatrixInverse);else{let It=Tt+bt,G=Ze+bt,We=tn-Ut,fe=$t+(Ve-Ut),P=mt*Ze/G*It,y=ct*Ze/G*It;Q.projectionMatrix.makePerspective(We,fe,P,y,It,G),Q.projectionMatrixInverse.copy(Q.projectionMatrix).invert()}}function de(Q,ae){ae===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(ae.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let ae=Q.near,he=Q.far;g.texture!==null&&(g.depthNear>0&&(ae=g.depthNear),g.depthFar>0&&(he=g.depthFar)),U.near=F.near=E.near=ae,U.far=F.far=E.far=he,(k!==U.near||X!==U.far)&&(s.updateRenderState({depthNear:U.near,depthFar:U.far}),k=U.near,X=U.far),U.layers.mask=Q.layers.mask|6,E.layers.mask=U.layers.mask&-5,F.layers.mask=U.layers.mask&-3;let Ve=Q.parent,De=U.cameras;de(U,Ve);for(let ke=0;ke<De.length;ke++)de(De[ke],Ve);De.length===2?le(U,E,F):U.projectionMatrix.copy(E.projectionMatrix),ue(Q,U,Ve)};function ue(Q,ae,he){he===null?Q.matrix.copy(ae.matrixWorld):(Q.matrix.copy(he.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(ae.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(ae.projectionMatrix),Q.projectionMatrixInverse.copy(ae.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Ho*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return U},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(Q){l=Q,d!==null&&(d.fixedFoveation=Q),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Q)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(U)},this.getCameraTexture=function(Q){return m[Q]};let _e=null;function st(Q,ae){if(u=ae.getViewerPose(c||o),p=ae,u!==null){let he=u.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let Ve=!1;he.length!==U.cameras.length&&(U.cameras.length=0,Ve=!0);for(let Ze=0;Ze<he.length;Ze++){let mt=he[Ze],ct=null;if(f!==null)ct=f.getViewport(mt);else{let qt=h.getViewSubImage(d,mt);ct=qt.viewport,Ze===0&&(e.setRenderTargetTextures(b,qt.colorTexture,qt.depthStencilTexture),e.setRenderTarget(b))}let ot=I[Ze];ot===void 0&&(ot=new Xn,ot.layers.enable(Ze),ot.viewport=new Qt,I[Ze]=ot),ot.matrix.fromArray(mt.transform.matrix),ot.matrix.decompose(ot.position,ot.quaternion,ot.scale),ot.projectionMatrix.fromArray(mt.projectionMatrix),ot.projectionMatrixInverse.copy(ot.projectionMatrix).invert(),ot.viewport.set(ct.x,ct.y,ct.width,ct.height),Ze===0&&(U.matrix.copy(ot.matrix),U.matrix.decompose(U.position,U.quaternion,U.scale)),Ve===!0&&U.cameras.push(ot)}let De=s.enabledFeatures;if(De&&De.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){h=i.getBinding();let Ze=h.getDepthInformation(he[0]);Ze&&Ze.isValid&&Ze.texture&&g.init(Ze,s.renderState)}if(De&&De.includes("camera-access")&&_){e.state.unbindTexture(),h=i.getBinding();for(let Ze=0;Ze<he.length;Ze++){let mt=he[Ze].camera;if(mt){let ct=m[mt];ct||(ct=new ja,m[mt]=ct);let ot=h.getCameraImage(mt);ct.sourceTexture=ot}}}}for(let he=0;he<R.length;he++){let Ve=T[he],De=R[he];Ve!==null&&De!==void 0&&De.update(Ve,ae,c||o)}_e&&_e(Q,ae),ae.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ae}),p=null}let et=new $_;et.setAnimationLoop(st),this.setAnimationLoop=function(Q){_e=Q},this.dispose=function(){}}},sA=new Vt,Q_=new it;Q_.set(-1,0,0,0,1,0,0,0,1);function rA(n,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function i(g,m){m.color.getRGB(g.fogColor.value,Xf(n)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,S,C,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),h(g,m)):m.isMeshPhongMaterial?(r(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),d(g,m),m.isMeshPhysicalMaterial&&f(g,m,b)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),_(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,S,C):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===oi&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===oi&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let S=e.get(m),C=S.envMap,b=S.envMapRotation;C&&(g.envMap.value=C,g.envMapRotation.value.setFromMatrix4(sA.makeRotationFromEuler(b)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Q_),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,S,C){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*S,g.scale.value=C*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function h(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function d(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function f(g,m,S){g.ior.value=m.ior,m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===oi&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessRange[0],g.iridescenceThicknessMaximum.value=m.iridescenceThicknessRange[1],m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=S.texture,g.transmissionSamplerSize.value.set(S.width,S.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function _(g,m){let S=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(S.matrixWorld),g.nearDistance.value=S.shadow.camera.near,g.farDistance.value=S.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function oA(n,e,t,i){let s={},r={},o=[],a=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function l(b,R){let T=R.program;i.uniformBlockBinding(b,T)}function c(b,R){let T=s[b.id];T===void 0&&(g(b),T=u(b),s[b.id]=T,b.addEventListener("dispose",S));let N=R.program;i.updateUBOMapping(b,N);let v=e.render.frame;r[b.id]!==v&&(d(b),r[b.id]=v)}function u(b){let R=h();b.__bindingPointIndex=R;let T=n.createBuffer(),N=b.__size,v=b.usage;return n.bindBuffer(n.UNIFORM_BUFFER,T),n.bufferData(n.UNIFORM_BUFFER,N,v),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,R,T),T}function h(){for(let b=0;b<a;b++)if(o.indexOf(b)===-1)return o.push(b),b;return Je("WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function d(b){let R=s[b.id],T=b.uniforms,N=b.__cache;n.bindBuffer(n.UNIFORM_BUFFER,R);for(let v=0,E=T.length;v<E;v++){let F=T[v];if(Array.isArray(F))for(let I=0,U=F.length;I<U;I++)f(F[I],v,I,N);else f(F,v,0,N)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function f(b,R,T,N){if(_(b,R,T,N)===!0){let v=b.__offset,E=b.value;if(Array.isArray(E)){let F=0;for(let I=0;I<E.length;I++){let U=E[I],k=m(U);p(U,b.__data,F),typeof U!="number"&&typeof U!="boolean"&&!U.isMatrix3&&!ArrayBuffer.isView(U)&&(F+=k.storage/Float32Array.BYTES_PER_ELEMENT)}}else p(E,b.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,v,b.__data)}}function p(b,R,T){typeof b=="number"||typeof b=="boolean"?R[0]=b:b.isMatrix3?(R[0]=b.elements[0],R[1]=b.elements[1],R[2]=b.elements[2],R[3]=0,R[4]=b.elements[3],R[5]=b.elements[4],R[6]=b.elements[5],R[7]=0,R[8]=b.elements[6],R[9]=b.elements[7],R[10]=b.elements[8],R[11]=0):ArrayBuffer.isView(b)?R.set(new b.constructor(b.buffer,b.byteOffset,R.length)):b.toArray(R,T)}function _(b,R,T,N){let v=b.value,E=R+"_"+T;if(N[E]===void 0)return typeof v=="number"||typeof v=="boolean"?N[E]=v:ArrayBuffer.isView(v)?N[E]=v.slice():N[E]=v.clone(),!0;{let F=N[E];if(typeof v=="number"||typeof v=="boolean"){if(F!==v)return N[E]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(F.equals(v)===!1)return F.copy(v),!0}}return!1}function g(b){let R=b.uniforms,T=0,N=16;for(let E=0,F=R.length;E<F;E++){let I=Array.isArray(R[E])?R[E]:[R[E]];for(let U=0,k=I.length;U<k;U++){let X=I[U],O=Array.isArray(X.value)?X.value:[X.value];for(let $=0,H=O.length;$<H;$++){let ie=O[$],oe=m(ie),le=T%N,de=le%oe.boundary,ue=le+de;T+=de,ue!==0&&N-ue<oe.storage&&(T+=N-ue),X.__data=new Float32Array(oe.storage/Float32Array.BYTES_PER_ELEMENT),X.__offset=T,T+=oe.storage}}}let v=T%N;return v>0&&(T+=N-v),b.__size=T,b.__cache={},this}function m(b){let R={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(R.boundary=4,R.storage=4):b.isVector2?(R.boundary=8,R.storage=8):b.isVector3||b.isColor?(R.boundary=16,R.storage=12):b.isVector4?(R.boundary=16,R.storage=16):b.isMatrix3?(R.boundary=48,R.storage=48):b.isMatrix4?(R.boundary=64,R.storage=64):b.isTexture?$e("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(b)?(R.boundary=16,R.storage=b.byteLength):$e("WebGLRenderer: Unsupported uniform value type.",b),R}function S(b){let R=b.target;R.removeEventListener("dispose",S);let T=o.indexOf(R.__bindingPointIndex);o.splice(T,1),n.deleteBuffer(s[R.id]),delete s[R.id],delete r[R.id]}function C(){for(let b in s)n.deleteBuffer(s[b]);o=[],s={},r={}}return{bind:l,update:c,dispose:C}}var aA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ms=null;function lA(){return ms===null&&(ms=new Wr(aA,16,16,mr,ps),ms.name="DFG_LUT",ms.minFilter=En,ms.magFilter=En,ms.wrapS=us,ms.wrapT=us,ms.generateMipmaps=!1,ms.needsUpdate=!0),ms}var mh=class{constructor(e={}){let{canvas:t=x_(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Ri}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let _=f,g=new Set([Lu,Iu,Pu]),m=new Set([Ri,ts,Ko,Jo,Cu,Ru]),S=new Uint32Array(4),C=new Int32Array(4),b=new z,R=null,T=null,N=[],v=[],E=null;this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=es,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let F=this,I=!1,U=null,k=null,X=null,O=null;this._outputColorSpace=Ti;let $=0,H=0,ie=null,oe=-1,le=null,de=new Qt,ue=new Qt,_e=null,st=new pt(0),et=0,Q=t.width,ae=t.height,he=1,Ve=null,De=null,ke=new Qt(0,0,Q,ae),Tt=new Qt(0,0,Q,ae),Ze=!1,mt=new Za,ct=!1,ot=!1,qt=new Vt,tn=new z,$t=new Qt,bt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ut=!1;function It(){return ie===null?he:1}let G=i;function We(w,W){return t.getContext(w,W)}try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"185"}`),t.addEventListener("webglcontextlost",lt,!1),t.addEventListener("webglcontextrestored",ht,!1),t.addEventListener("webglcontextcreationerror",Un,!1),G===null){let W="webgl2";if(G=We(W,w),G===null)throw We(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}}catch(w){throw Je("WebGLRenderer: "+w.message),w}let fe,P,y,q,K,ee,me,ge,te,ne,xe,Be,Me,ve,Oe,Xe,qe,V,be,se,Se,Ae,ce;function ze(){fe=new mT(G),fe.init(),Se=new tA(G,fe),P=new aT(G,fe,e,Se),y=new QE(G,fe),P.reversedDepthBuffer&&d&&y.buffers.depth.setReversed(!0),k=G.createFramebuffer(),X=G.createFramebuffer(),O=G.createFramebuffer(),q=new xT(G),K=new BE,ee=new eA(G,fe,y,K,P,Se,q),me=new pT(F),ge=new MS(G),Ae=new rT(G,ge),te=new gT(G,ge,q,Ae),ne=new vT(G,te,ge,Ae,q),V=new yT(G,P,ee),Oe=new lT(K),xe=new kE(F,me,fe,P,Ae,Oe),Be=new rA(F,K),Me=new zE,ve=new $E(fe),qe=new sT(F,me,y,ne,p,l),Xe=new jE(F,ne,P),ce=new oA(G,q,P,y),be=new oT(G,fe,q),se=new _T(G,fe,q),q.programs=xe.programs,F.capabilities=P,F.extensions=fe,F.properties=K,F.renderLists=Me,F.shadowMap=Xe,F.state=y,F.info=q}ze(),_!==Ri&&(E=new MT(_,t.width,t.height,a,s,r));let Ne=new cp(F,G);this.xr=Ne,this.getContext=function(){return G},this.getContextAttributes=function(){return G.getContextAttributes()},this.forceContextLoss=function(){let w=fe.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=fe.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return he},this.setPixelRatio=function(w){w!==void 0&&(he=w,this.setSize(Q,ae,!1))},this.getSize=function(w){return w.set(Q,ae)},this.setSize=function(w,W,j=!0){if(Ne.isPresenting){$e("WebGLRenderer: Can't change size while VR device is presenting.");return}Q=w,ae=W,t.width=Math.floor(w*he),t.height=Math.floor(W*he),j===!0&&(t.style.width=w+"px",t.style.height=W+"px"),E!==null&&E.setSize(t.width,t.height),this.setViewport(0,0,w,W)},this.getDrawingBufferSize=function(w){return w.set(Q*he,ae*he).floor()},this.setDrawingBufferSize=function(w,W,j){Q=w,ae=W,he=j,t.width=Math.floor(w*j),t.height=Math.floor(W*j),this.setViewport(0,0,w,W)},this.setEffects=function(w){if(_===Ri){Je("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let W=0;W<w.length;W++)if(w[W].isOutputPass===!0){$e("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}E.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(de)},this.getViewport=function(w){return w.copy(ke)},this.setViewport=function(w,W,j,Y){w.isVector4?ke.set(w.x,w.y,w.z,w.w):ke.set(w,W,j,Y),y.viewport(de.copy(ke).multiplyScalar(he).round())},this.getScissor=function(w){return w.copy(Tt)},this.setScissor=function(w,W,j,Y){w.isVector4?Tt.set(w.x,w.y,w.z,w.w):Tt.set(w,W,j,Y),y.scissor(ue.copy(Tt).multiplyScalar(he).round())},this.getScissorTest=function(){return Ze},this.setScissorTest=function(w){y.setScissorTest(Ze=w)},this.setOpaqueSort=function(w){Ve=w},this.setTransparentSort=function(w){De=w},this.getClearColor=function(w){return w.copy(qe.getClearColor())},this.setClearColor=function(){qe.setClearColor(...arguments)},this.getClearAlpha=function(){return qe.getClearAlpha()},this.setClearAlpha=function(){qe.setClearAlpha(...arguments)},this.clear=function(w=!0,W=!0,j=!0){let Y=0;if(w){let J=!1;if(ie!==null){let Te=ie.texture.format;J=g.has(Te)}if(J){let Te=ie.texture.type,Pe=m.has(Te),we=qe.getClearColor(),Ue=qe.getClearAlpha(),Ce=we.r,tt=we.g,rt=we.b;Pe?(S[0]=Ce,S[1]=tt,S[2]=rt,S[3]=Ue,G.clearBufferuiv(G.COLOR,0,S)):(C[0]=Ce,C[1]=tt,C[2]=rt,C[3]=Ue,G.clearBufferiv(G.COLOR,0,C))}else Y|=G.COLOR_BUFFER_BIT}W&&(Y|=G.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=G.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&G.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),U=w},this.dispose=function(){t.removeEventListener("webglcontextlost",lt,!1),t.removeEventListener("webglcontextrestored",ht,!1),t.removeEventListener("webglcontextcreationerror",Un,!1),qe.dispose(),Me.dispose(),ve.dispose(),K.dispose(),me.dispose(),ne.dispose(),Ae.dispose(),ce.dispose(),xe.dispose(),Ne.dispose(),Ne.removeEventListener("sessionstart",Tl),Ne.removeEventListener("sessionend",El),Zn.stop()};function lt(w){w.preventDefault(),Gf("WebGLRenderer: Context Lost."),I=!0}function ht(){Gf("WebGLRenderer: Context Restored."),I=!1;let w=q.autoReset,W=Xe.enabled,j=Xe.autoUpdate,Y=Xe.needsUpdate,J=Xe.type;ze(),q.autoReset=w,Xe.enabled=W,Xe.autoUpdate=j,Xe.needsUpdate=Y,Xe.type=J}function Un(w){Je("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function On(w){let W=w.target;W.removeEventListener("dispose",On),li(W)}function li(w){Ds(w),K.remove(w)}function Ds(w){let W=K.get(w).programs;W!==void 0&&(W.forEach(function(j){xe.releaseProgram(j)}),w.isShaderMaterial&&xe.releaseShaderCache(w))}this.renderBufferDirect=function(w,W,j,Y,J,Te){W===null&&(W=bt);let Pe=J.isMesh&&J.matrixWorld.determinantAffine()<0,we=Sr(w,W,j,Y,J);y.setMaterial(Y,Pe);let Ue=j.index,Ce=1;if(Y.wireframe===!0){if(Ue=te.getWireframeAttribute(j),Ue===void 0)return;Ce=2}let tt=j.drawRange,rt=j.attributes.position,Ge=tt.start*Ce,Et=(tt.start+tt.count)*Ce;Te!==null&&(Ge=Math.max(Ge,Te.start*Ce),Et=Math.min(Et,(Te.start+Te.count)*Ce)),Ue!==null?(Ge=Math.max(Ge,0),Et=Math.min(Et,Ue.count)):rt!=null&&(Ge=Math.max(Ge,0),Et=Math.min(Et,rt.count));let an=Et-Ge;if(an<0||an===1/0)return;Ae.setup(J,Y,we,j,Ue);let nn,Ot=be;if(Ue!==null&&(nn=ge.get(Ue),Ot=se,Ot.setIndex(nn)),J.isMesh)Y.wireframe===!0?(y.setLineWidth(Y.wireframeLinewidth*It()),Ot.setMode(G.LINES)):Ot.setMode(G.TRIANGLES);else if(J.isLine){let bn=Y.linewidth;bn===void 0&&(bn=1),y.setLineWidth(bn*It()),J.isLineSegments?Ot.setMode(G.LINES):J.isLineLoop?Ot.setMode(G.LINE_LOOP):Ot.setMode(G.LINE_STRIP)}else J.isPoints?Ot.setMode(G.POINTS):J.isSprite&&Ot.setMode(G.TRIANGLES);if(J.isBatchedMesh)if(fe.get("WEBGL_multi_draw"))Ot.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let bn=J._multiDrawStarts,Ie=J._multiDrawCounts,Kn=J._multiDrawCount,gt=Ue?ge.get(Ue).bytesPerElement:1,zn=K.get(Y).currentProgram.getUniforms();for(let Jn=0;Jn<Kn;Jn++)zn.setValue(G,"_gl_DrawID",Jn),Ot.render(bn[Jn]/gt,Ie[Jn])}else if(J.isInstancedMesh)Ot.renderInstances(Ge,an,J.count);else if(j.isInstancedBufferGeometry){let bn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ie=Math.min(j.instanceCount,bn);Ot.renderInstances(Ge,an,Ie)}else Ot.render(Ge,an)};function _s(w,W,j){w.transparent===!0&&w.side===$n&&w.forceSinglePass===!1?(w.side=oi,w.needsUpdate=!0,on(w,W,j),w.side=ji,w.needsUpdate=!0,on(w,W,j),w.side=$n):on(w,W,j)}this.compile=function(w,W,j=null){j===null&&(j=w),T=ve.get(j),T.init(W),v.push(T),j.traverseVisible(function(J){J.isLight&&J.layers.test(W.layers)&&(T.pushLight(J),J.castShadow&&T.pushShadow(J))}),w!==j&&w.traverseVisible(function(J){J.isLight&&J.layers.test(W.layers)&&(T.pushLight(J),J.castShadow&&T.pushShadow(J))}),T.setupLights();let Y=new Set;return w.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Te=J.material;if(Te)if(Array.isArray(Te))for(let Pe=0;Pe<Te.length;Pe++){let we=Te[Pe];_s(we,j,J),Y.add(we)}else _s(Te,j,J),Y.add(Te)}),T=v.pop(),Y},this.compileAsync=function(w,W,j=null){let Y=this.compile(w,W,j);return new Promise(J=>{function Te(){if(Y.forEach(function(Pe){K.get(Pe).currentProgram.isReady()&&Y.delete(Pe)}),Y.size===0){J(w);return}setTimeout(Te,10)}fe.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let jr=null;function wl(w){jr&&jr(w)}function Tl(){Zn.stop()}function El(){Zn.start()}let Zn=new $_;Zn.setAnimationLoop(wl),typeof self<"u"&&Zn.setContext(self),this.setAnimationLoop=function(w){jr=w,Ne.setAnimationLoop(w),w===null?Zn.stop():Zn.start()},Ne.addEventListener("sessionstart",Tl),Ne.addEventListener("sessionend",El),this.render=function(w,W){if(W!==void 0&&W.isCamera!==!0){Je("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;U!==null&&U.renderStart(w,W);let j=Ne.enabled===!0&&Ne.isPresenting===!0,Y=E!==null&&(ie===null||j)&&E.begin(F,ie);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),Ne.enabled===!0&&Ne.isPresenting===!0&&(E===null||E.isCompositing()===!1)&&(Ne.cameraAutoUpdate===!0&&Ne.updateCamera(W),W=Ne.getCamera()),w.isScene===!0&&w.onBeforeRender(F,w,W,ie),T=ve.get(w,v.length),T.init(W),T.state.textureUnits=ee.getTextureUnits(),v.push(T),qt.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),mt.setFromProjectionMatrix(qt,Ji,W.reversedDepth),ot=this.localClippingEnabled,ct=Oe.init(this.clippingPlanes,ot),R=Me.get(w,N.length),R.init(),N.push(R),Ne.enabled===!0&&Ne.isPresenting===!0){let Pe=F.xr.getDepthSensingMesh();Pe!==null&&oa(Pe,W,-1/0,F.sortObjects)}oa(w,W,0,F.sortObjects),R.finish(),F.sortObjects===!0&&R.sort(Ve,De,W.reversedDepth),Ut=Ne.enabled===!1||Ne.isPresenting===!1||Ne.hasDepthSensing()===!1,Ut&&qe.addToRenderList(R,w),this.info.render.frame++,this.info.autoReset===!0&&this.info.reset(),ct===!0&&Oe.beginShadows();let J=T.state.shadowsArray;if(Xe.render(J,w,W),ct===!0&&Oe.endShadows(),(Y&&E.hasRenderPass())===!1){let Pe=R.opaque,we=R.transmissive;if(T.setupLights(),W.isArrayCamera){let Ue=W.cameras;if(we.length>0)for(let Ce=0,tt=Ue.length;Ce<tt;Ce++){let rt=Ue[Ce];aa(Pe,we,w,rt)}Ut&&qe.render(w);for(let Ce=0,tt=Ue.length;Ce<tt;Ce++){let rt=Ue[Ce];Fs(R,w,rt,rt.viewport)}}else we.length>0&&aa(Pe,we,w,W),Ut&&qe.render(w),Fs(R,w,W)}ie!==null&&H===0&&(ee.updateMultisampleRenderTarget(ie),ee.updateRenderTargetMipmap(ie)),Y&&E.end(F),w.isScene===!0&&w.onAfterRender(F,w,W),Ae.resetDefaultState(),oe=-1,le=null,v.pop(),v.length>0?(T=v[v.length-1],ee.setTextureUnits(T.state.textureUnits),ct===!0&&Oe.setGlobalState(F.clippingPlanes,T.state.camera)):T=null,N.pop(),N.length>0?R=N[N.length-1]:R=null,U!==null&&U.renderEnd()};function oa(w,W,j,Y){if(w.visible===!1)return;if(w.layers.test(W.layers)){if(w.isGroup)j=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(W);else if(w.isLightProbeGrid)T.pushLightProbeGrid(w);else if(w.isLight)T.pushLight(w),w.castShadow&&T.pushShadow(w);else if(w.isSprite){if(!w.frustumCulled||mt.intersectsSprite(w)){Y&&$t.setFromMatrixPosition(w.matrixWorld).applyMatrix4(qt);let Pe=ne.update(w),we=w.material;we.visible&&R.push(w,Pe,we,j,$t.z,null)}}else if((w.isMesh||w.isLine||w.isPoints)&&(!w.frustumCulled||mt.intersectsObject(w))){let Pe=ne.update(w),we=w.material;if(Y&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),$t.copy(w.boundingSphere.center)):(Pe.boundingSphere===null&&Pe.computeBoundingSphere(),$t.copy(Pe.boundingSphere.center)),$t.applyMatrix4(w.matrixWorld).applyMatrix4(qt)),Array.isArray(we)){let Ue=Pe.groups;for(let Ce=0,tt=Ue.length;Ce<tt;Ce++){let rt=Ue[Ce],Ge=we[rt.materialIndex];Ge&&Ge.visible&&R.push(w,Pe,Ge,j,$t.z,rt)}}else we.visible&&R.push(w,Pe,we,j,$t.z,null)}}let Te=w.children;for(let Pe=0,we=Te.length;Pe<we;Pe++)oa(Te[Pe],W,j,Y)}function Fs(w,W,j,Y){let{opaque:J,transmissive:Te,transparent:Pe}=w;T.setupLightsView(j),ct===!0&&Oe.setGlobalState(F.clippingPlanes,j),Y&&y.viewport(de.copy(Y)),J.length>0&&fi(J,W,j),Te.length>0&&fi(Te,W,j),Pe.length>0&&fi(Pe,W,j),y.buffers.depth.setTest(!0),y.buffers.depth.setMask(!0),y.buffers.color.setMask(!0),y.setPolygonOffset(!1)}function aa(w,W,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[Y.id]===void 0){let Ge=fe.has("EXT_color_buffer_half_float")||fe.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[Y.id]=new Ai(1,1,{generateMipmaps:!0,type:Ge?ps:Ri,minFilter:fr,samples:Math.max(4,P.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:xt.workingColorSpace})}let Te=T.state.transmissionRenderTarget[Y.id],Pe=Y.viewport||de;Te.setSize(Pe.z*F.transmissionResolutionScale,Pe.w*F.transmissionResolutionScale);let we=F.getRenderTarget(),Ue=F.getActiveCubeFace(),Ce=F.getActiveMipmapLevel();F.setRenderTarget(Te),F.getClearColor(st),et=F.getClearAlpha(),et<1&&F.setClearColor(16777215,.5),F.clear(),Ut&&qe.render(j);let tt=F.toneMapping;F.toneMapping=es;let rt=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),T.setupLightsView(Y),ct===!0&&Oe.setGlobalState(F.clippingPlanes,Y),fi(w,j,Y),ee.updateMultisampleRenderTarget(Te),ee.updateRenderTargetMipmap(Te),fe.has("WEBGL_multisampled_render_to_texture")===!1){let Ge=!1;for(let Et=0,an=W.length;Et<an;Et++){let nn=W[Et],{object:Ot,geometry:bn,material:Ie,group:Kn}=nn;if(Ie.side===$n&&Ot.layers.test(Y.layers)){let gt=Ie.side;Ie.side=oi,Ie.needsUpdate=!0,gn(Ot,j,Y,bn,Ie,Kn),Ie.side=gt,Ie.needsUpdate=!0,Ge=!0}}Ge===!0&&(ee.updateMultisampleRenderTarget(Te),ee.updateRenderTargetMipmap(Te))}F.setRenderTarget(we,Ue,Ce),F.setClearColor(st,et),rt!==void 0&&(Y.viewport=rt),F.toneMapping=tt}function fi(w,W,j){let Y=W.isScene===!0?W.overrideMaterial:null;for(let J=0,Te=w.length;J<Te;J++){let Pe=w[J],{object:we,geometry:Ue,group:Ce}=Pe,tt=Pe.material;tt.allowOverride===!0&&Y!==null&&(tt=Y),we.layers.test(j.layers)&&gn(we,W,j,Ue,tt,Ce)}}function gn(w,W,j,Y,J,Te){w.onBeforeRender(F,W,j,Y,J,Te),w.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),J.onBeforeRender(F,W,j,Y,w,Te),J.transparent===!0&&J.side===$n&&J.forceSinglePass===!1?(J.side=oi,J.needsUpdate=!0,F.renderBufferDirect(j,W,Y,J,w,Te),J.side=ji,J.needsUpdate=!0,F.renderBufferDirect(j,W,Y,J,w,Te),J.side=$n):F.renderBufferDirect(j,W,Y,J,w,Te),w.onAfterRender(F,W,j,Y,J,Te)}function on(w,W,j){W.isScene!==!0&&(W=bt);let Y=K.get(w),J=T.state.lights,Te=T.state.shadowsArray,Pe=J.state.version,we=xe.getParameters(w,J.state,Te,W,j,T.state.lightProbeGridArray),Ue=xe.getProgramCacheKey(we),Ce=Y.programs;Y.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?W.environment:null,Y.fog=W.fog;let tt=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;Y.envMap=me.get(w.envMap||Y.environment,tt),Y.envMapRotation=Y.environment!==null&&w.envMap===null?W.environmentRotation:w.envMapRotation,Ce===void 0&&(w.addEventListener("dispose",On),Ce=new Map,Y.programs=Ce);let rt=Ce.get(Ue);if(rt!==void 0){if(Y.currentProgram===rt&&Y.lightsStateVersion===Pe)return Mr(w,we),rt}else we.uniforms=xe.getUniforms(w),U!==null&&w.isNodeMaterial&&U.build(w,j,we),w.onBeforeCompile(we,F),rt=xe.acquireProgram(we,Ue),Ce.set(Ue,rt),Y.uniforms=we.uniforms;let Ge=Y.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Ge.clippingPlanes=Oe.uniform),Mr(w,we),Y.needsLights=la(w),Y.lightsStateVersion=Pe,Y.needsLights&&(Ge.ambientLightColor.value=J.state.ambient,Ge.lightProbe.value=J.state.probe,Ge.directionalLights.value=J.state.directional,Ge.directionalLightShadows.value=J.state.directionalShadow,Ge.spotLights.value=J.state.spot,Ge.spotLightShadows.value=J.state.spotShadow,Ge.rectAreaLights.value=J.state.rectArea,Ge.ltc_1.value=J.state.rectAreaLTC1,Ge.ltc_2.value=J.state.rectAreaLTC2,Ge.pointLights.value=J.state.point,Ge.pointLightShadows.value=J.state.pointShadow,Ge.hemisphereLights.value=J.state.hemi,Ge.directionalShadowMatrix.value=J.state.directionalShadowMatrix,Ge.spotLightMatrix.value=J.state.spotLightMatrix,Ge.spotLightMap.value=J.state.spotLightMap,Ge.pointShadowMatrix.value=J.state.pointShadowMatrix),Y.lightProbeGrid=T.state.lightProbeGridArray.length>0,Y.currentProgram=rt,Y.uniformsList=null,rt}function pn(w){if(w.uniformsList===null){let W=w.currentProgram.getUniforms();w.uniformsList=ea.seqWithValue(W.seq,w.uniforms)}return w.uniformsList}function Mr(w,W){let j=K.get(w);j.outputColorSpace=W.outputColorSpace,j.batching=W.batching,j.batchingColor=W.batchingColor,j.instancing=W.instancing,j.instancingColor=W.instancingColor,j.instancingMorph=W.instancingMorph,j.skinning=W.skinning,j.morphTargets=W.morphTargets,j.morphNormals=W.morphNormals,j.morphColors=W.morphColors,j.morphTargetsCount=W.morphTargetsCount,j.numClippingPlanes=W.numClippingPlanes,j.numIntersection=W.numClipIntersection,j.vertexAlphas=W.vertexAlphas,j.vertexTangents=W.vertexTangents,j.toneMapping=W.toneMapping}function pi(w,W){if(w.length===0)return null;if(w.length===1)return w[0].texture!==null?w[0]:null;b.setFromMatrixPosition(W.matrixWorld);for(let j=0,Y=w.length;j<Y;j++){let J=w[j];if(J.texture!==null&&J.boundingBox.containsPoint(b))return J}return null}function Sr(w,W,j,Y,J){W.isScene!==!0&&(W=bt),ee.resetTextureUnits();let Te=W.fog,Pe=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?W.environment:null,we=ie===null?F.outputColorSpace:ie.isXRRenderTarget===!0?ie.texture.colorSpace:xt.workingColorSpace,Ue=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Ce=me.get(Y.envMap||Pe,Ue),tt=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,rt=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Ge=!!j.morphAttributes.position,Et=!!j.morphAttributes.normal,an=!!j.morphAttributes.color,nn=es;Y.toneMapped&&(ie===null||ie.isXRRenderTarget===!0)&&(nn=F.toneMapping);let Ot=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,bn=Ot!==void 0?Ot.length:0,Ie=K.get(Y),Kn=T.state.lights;if(ct===!0&&(ot===!0||w!==le)){let zt=w===le&&Y.id===oe;Oe.setState(Y,w,zt)}let gt=!1;Y.version===Ie.__version?(Ie.needsLights&&Ie.lightsStateVersion!==Kn.state.version||Ie.outputColorSpace!==we||J.isBatchedMesh&&Ie.batching===!1||!J.isBatchedMesh&&Ie.batching===!0||J.isBatchedMesh&&Ie.batchingColor===!0&&J.colorTexture===null||J.isBatchedMesh&&Ie.batchingColor===!1&&J.colorTexture!==null||J.isInstancedMesh&&Ie.instancing===!1||!J.isInstancedMesh&&Ie.instancing===!0||J.isSkinnedMesh&&Ie.skinning===!1||!J.isSkinnedMesh&&Ie.skinning===!0||J.isInstancedMesh&&Ie.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Ie.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Ie.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Ie.instancingMorph===!1&&J.morphTexture!==null||Ie.envMap!==Ce||Y.fog===!0&&Ie.fog!==Te||Ie.numClippingPlanes!==void 0&&(Ie.numClippingPlanes!==Oe.numPlanes||Ie.numIntersection!==Oe.numIntersection)||Ie.vertexAlphas!==tt||Ie.vertexTangents!==rt||Ie.morphTargets!==Ge||Ie.morphNormals!==Et||Ie.morphColors!==an||Ie.toneMapping!==nn||Ie.morphTargetsCount!==bn||!!Ie.lightProbeGrid!=T.state.lightProbeGridArray.length>0)&&(gt=!0):(gt=!0,Ie.__version=Y.version);let zn=Ie.currentProgram;gt===!0&&(zn=on(Y,W,J),U&&Y.isNodeMaterial&&U.onUpdateProgram(Y,zn,Ie));let Jn=!1,mi=!1,Us=!1,At=zn.getUniforms(),ln=Ie.uniforms;if(y.useProgram(zn.program)&&(Jn=!0,mi=!0,Us=!0),Y.id!==oe&&(oe=Y.id,mi=!0),Ie.needsLights){let zt=pi(T.state.lightProbeGridArray,J);Ie.lightProbeGrid!==zt&&(Ie.lightProbeGrid=zt,mi=!0)}if(Jn||le!==w){y.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),At.setValue(G,"projectionMatrix",w.projectionMatrix),At.setValue(G,"viewMatrix",w.matrixWorldInverse);let jn=At.map.cameraPosition;jn!==void 0&&jn.setValue(G,tn.setFromMatrixPosition(w.matrixWorld)),P.logarithmicDepthBuffer&&At.setValue(G,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&At.setValue(G,"isOrthographic",w.isOrthographicCamera===!0),le!==w&&(le=w,mi=!0,Us=!0)}if(Ie.needsLights&&(Kn.state.directionalShadowMap.length>0&&At.setValue(G,"directionalShadowMap",Kn.state.directionalShadowMap,ee),Kn.state.spotShadowMap.length>0&&At.setValue(G,"spotShadowMap",Kn.state.spotShadowMap,ee),Kn.state.pointShadowMap.length>0&&At.setValue(G,"pointShadowMap",Kn.state.pointShadowMap,ee)),J.isSkinnedMesh){At.setOptional(G,J,"bindMatrix"),At.setOptional(G,J,"bindMatrixInverse");let zt=J.skeleton;zt&&(zt.boneTexture===null&&zt.computeBoneTexture(),At.setValue(G,"boneTexture",zt.boneTexture,ee))}J.isBatchedMesh&&(At.setOptional(G,J,"batchingTexture"),At.setValue(G,"batchingTexture",J._matricesTexture,ee),At.setOptional(G,J,"batchingIdTexture"),At.setValue(G,"batchingIdTexture",J._indirectTexture,ee),At.setOptional(G,J,"batchingColorTexture"),J._colorsTexture!==null&&At.setValue(G,"batchingColorTexture",J._colorsTexture,ee));let ns=j.morphAttributes;if((ns.position!==void 0||ns.normal!==void 0||ns.color!==void 0)&&V.update(J,j,zn),(mi||Ie.receiveShadow!==J.receiveShadow)&&(Ie.receiveShadow=J.receiveShadow,At.setValue(G,"receiveShadow",J.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&W.environment!==null&&(ln.envMapIntensity.value=W.environmentIntensity),ln.dfgLUT!==void 0&&(ln.dfgLUT.value=lA()),mi){if(At.setValue(G,"toneMappingExposure",F.toneMappingExposure),Ie.needsLights&&Al(ln,Us),Te&&Y.fog===!0&&Be.refreshFogUniforms(ln,Te),Be.refreshMaterialUniforms(ln,Y,he,ae,T.state.transmissionRenderTarget[w.id]),Ie.needsLights&&Ie.lightProbeGrid){let zt=Ie.lightProbeGrid;ln.probesSH.value=zt.texture,ln.probesMin.value.copy(zt.boundingBox.min),ln.probesMax.value.copy(zt.boundingBox.max),ln.probesResolution.value.copy(zt.resolution)}ea.upload(G,pn(Ie),ln,ee)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(ea.upload(G,pn(Ie),ln,ee),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&At.setValue(G,"center",J.center),At.setValue(G,"modelViewMatrix",J.modelViewMatrix),At.setValue(G,"normalMatrix",J.normalMatrix),At.setValue(G,"modelMatrix",J.matrixWorld),Y.uniformsGroups!==void 0){let zt=Y.uniformsGroups;for(let jn=0,Vi=zt.length;jn<Vi;jn++){let Qr=zt[jn];ce.update(Qr,zn),ce.bind(Qr,zn)}}return zn}function Al(w,W){w.ambientLightColor.needsUpdate=W,w.lightProbe.needsUpdate=W,w.directionalLights.needsUpdate=W,w.directionalLightShadows.needsUpdate=W,w.pointLights.needsUpdate=W,w.pointLightShadows.needsUpdate=W,w.spotLights.needsUpdate=W,w.spotLightShadows.needsUpdate=W,w.rectAreaLights.needsUpdate=W,w.hemisphereLights.needsUpdate=W}function la(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return ie},this.setRenderTargetTextures=function(w,W,j){let Y=K.get(w);Y.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),K.get(w.texture).__webglTexture=W,K.get(w.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,W){let j=K.get(w);j.__webglFramebuffer=W,j.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(w,W=0,j=0){ie=w,$=W,H=j;let Y=null,J=!1,Te=!1;if(w){let we=K.get(w);if(we.__useDefaultFramebuffer!==void 0){y.bindFramebuffer(G.FRAMEBUFFER,we.__webglFramebuffer),de.copy(w.viewport),ue.copy(w.scissor),_e=w.scissorTest,y.viewport(de),y.scissor(ue),y.setScissorTest(_e),oe=-1;return}else if(we.__webglFramebuffer===void 0)ee.setupRenderTarget(w);else if(we.__hasExternalTextures)ee.rebindTextures(w,K.get(w.texture).__webglTexture,K.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let tt=w.depthTexture;if(we.__boundDepthTexture!==tt){if(tt!==null&&K.has(tt)&&(w.width!==tt.image.width||w.height!==tt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");ee.setupDepthRenderbuffer(w)}}let Ue=w.texture;(Ue.isData3DTexture||Ue.isDataArrayTexture||Ue.isCompressedArrayTexture)&&(Te=!0);let Ce=K.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Ce[W])?Y=Ce[W][j]:Y=Ce[W],J=!0):w.samples>0&&ee.useMultisampledRTT(w)===!1?Y=K.get(w).__webglMultisampledFramebuffer:Array.isArray(Ce)?Y=Ce[j]:Y=Ce,de.copy(w.viewport),ue.copy(w.scissor),_e=w.scissorTest}else de.copy(ke).multiplyScalar(he).floor(),ue.copy(Tt).multiplyScalar(he).floor(),_e=Ze;if(j!==0&&(Y=k),y.bindFramebuffer(G.FRAMEBUFFER,Y)&&y.drawBuffers(w,Y),y.viewport(de),y.scissor(ue),y.setScissorTest(_e),J){let we=K.get(w.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_CUBE_MAP_POSITIVE_X+W,we.__webglTexture,j)}else if(Te){let we=W;for(let Ue=0;Ue<w.textures.length;Ue++){let Ce=K.get(w.textures[Ue]);G.framebufferTextureLayer(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0+Ue,Ce.__webglTexture,j,we)}}else if(w!==null&&j!==0){let we=K.get(w.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,we.__webglTexture,j)}oe=-1},this.readRenderTargetPixels=function(w,W,j,Y,J,Te,Pe,we=0){if(!(w&&w.isWebGLRenderTarget)){Je("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ue=K.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ue=Ue[Pe]),Ue){y.bindFramebuffer(G.FRAMEBUFFER,Ue);try{let Ce=w.textures[we],tt=Ce.format,rt=Ce.type;if(w.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+we),!P.textureFormatReadable(tt)){Je("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!P.textureTypeReadable(rt)){Je("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=w.width-Y&&j>=0&&j<=w.height-J&&G.readPixels(W,j,Y,J,Se.convert(tt),Se.convert(rt),Te)}finally{let Ce=ie!==null?K.get(ie).__webglFramebuffer:null;y.bindFramebuffer(G.FRAMEBUFFER,Ce)}}},this.readRenderTargetPixelsAsync=async function(w,W,j,Y,J,Te,Pe,we=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ue=K.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ue=Ue[Pe]),Ue)if(W>=0&&W<=w.width-Y&&j>=0&&j<=w.height-J){y.bindFramebuffer(G.FRAMEBUFFER,Ue);let Ce=w.textures[we],tt=Ce.format,rt=Ce.type;if(w.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+we),!P.textureFormatReadable(tt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!P.textureTypeReadable(rt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Ge=G.createBuffer();G.bindBuffer(G.PIXEL_PACK_BUFFER,Ge),G.bufferData(G.PIXEL_PACK_BUFFER,Te.byteLength,G.STREAM_READ),G.readPixels(W,j,Y,J,Se.convert(tt),Se.convert(rt),0);let Et=ie!==null?K.get(ie).__webglFramebuffer:null;y.bindFramebuffer(G.FRAMEBUFFER,Et);let an=G.fenceSync(G.SYNC_GPU_COMMANDS_COMPLETE,0);return G.flush(),await v_(G,an,4),G.bindBuffer(G.PIXEL_PACK_BUFFER,Ge),G.getBufferSubData(G.PIXEL_PACK_BUFFER,0,Te),G.deleteBuffer(Ge),G.deleteSync(an),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,W=null,j=0){let Y=Math.pow(2,-j),J=Math.floor(w.image.width*Y),Te=Math.floor(w.image.height*Y),Pe=W!==null?W.x:0,we=W!==null?W.y:0;ee.setTexture2D(w,0),G.copyTexSubImage2D(G.TEXTURE_2D,j,0,0,Pe,we,J,Te),y.unbindTexture()},this.copyTextureToTexture=function(w,W,j=null,Y=null,J=0,Te=0){let Pe,we,Ue,Ce,tt,rt,Ge,Et,an,nn=w.isCompressedTexture?w.mipmaps[Te]:w.image;if(j!==null)Pe=j.max.x-j.min.x,we=j.max.y-j.min.y,Ue=j.isBox3?j.max.z-j.min.z:1,Ce=j.min.x,tt=j.min.y,rt=j.isBox3?j.min.z:0;else{let ln=Math.pow(2,-J);Pe=Math.floor(nn.width*ln),we=Math.floor(nn.height*ln),w.isDataArrayTexture?Ue=nn.depth:w.isData3DTexture?Ue=Math.floor(nn.depth*ln):Ue=1,Ce=0,tt=0,rt=0}Y!==null?(Ge=Y.x,Et=Y.y,an=Y.z):(Ge=0,Et=0,an=0);let Ot=Se.convert(W.format),bn=Se.convert(W.type),Ie;W.isData3DTexture?(ee.setTexture3D(W,0),Ie=G.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?(ee.setTexture2DArray(W,0),Ie=G.TEXTURE_2D_ARRAY):(ee.setTexture2D(W,0),Ie=G.TEXTURE_2D),y.activeTexture(G.TEXTURE0),y.pixelStorei(G.UNPACK_FLIP_Y_WEBGL,W.flipY),y.pixelStorei(G.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),y.pixelStorei(G.UNPACK_ALIGNMENT,W.unpackAlignment);let Kn=y.getParameter(G.UNPACK_ROW_LENGTH),gt=y.getParameter(G.UNPACK_IMAGE_HEIGHT),zn=y.getParameter(G.UNPACK_SKIP_PIXELS),Jn=y.getParameter(G.UNPACK_SKIP_ROWS),mi=y.getParameter(G.UNPACK_SKIP_IMAGES);y.pixelStorei(G.UNPACK_ROW_LENGTH,nn.width),y.pixelStorei(G.UNPACK_IMAGE_HEIGHT,nn.height),y.pixelStorei(G.UNPACK_SKIP_PIXELS,Ce),y.pixelStorei(G.UNPACK_SKIP_ROWS,tt),y.pixelStorei(G.UNPACK_SKIP_IMAGES,rt);let Us=w.isDataArrayTexture||w.isData3DTexture,At=W.isDataArrayTexture||W.isData3DTexture;if(w.isDepthTexture){let ln=K.get(w),ns=K.get(W),zt=K.get(ln.__renderTarget),jn=K.get(ns.__renderTarget);y.bindFramebuffer(G.READ_FRAMEBUFFER,zt.__webglFramebuffer),y.bindFramebuffer(G.DRAW_FRAMEBUFFER,jn.__webglFramebuffer);for(let Vi=0;Vi<Ue;Vi++)Us&&(G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,K.get(w).__webglTexture,J,rt+Vi),G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,K.get(W).__webglTexture,Te,an+Vi)),G.blitFramebuffer(Ce,tt,Pe,we,Ge,Et,Pe,we,G.DEPTH_BUFFER_BIT,G.NEAREST);y.bindFramebuffer(G.READ_FRAMEBUFFER,null),y.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else if(J!==0||w.isRenderTargetTexture||K.has(w)){let ln=K.get(w),ns=K.get(W);y.bindFramebuffer(G.READ_FRAMEBUFFER,X),y.bindFramebuffer(G.DRAW_FRAMEBUFFER,O);for(let zt=0;zt<Ue;zt++)Us?G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,ln.__webglTexture,J,rt+zt):G.framebufferTexture2D(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,ln.__webglTexture,J),At?G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,ns.__webglTexture,Te,an+zt):G.framebufferTexture2D(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,ns.__webglTexture,Te),J!==0?G.blitFramebuffer(Ce,tt,Pe,we,Ge,Et,Pe,we,G.COLOR_BUFFER_BIT,G.NEAREST):At?G.copyTexSubImage3D(Ie,Te,Ge,Et,an+zt,Ce,tt,Pe,we):G.copyTexSubImage2D(Ie,Te,Ge,Et,Ce,tt,Pe,we);y.bindFramebuffer(G.READ_FRAMEBUFFER,null),y.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else At?w.isDataTexture||w.isData3DTexture?G.texSubImage3D(Ie,Te,Ge,Et,an,Pe,we,Ue,Ot,bn,nn.data):W.isCompressedArrayTexture?G.compressedTexSubImage3D(Ie,Te,Ge,Et,an,Pe,we,Ue,Ot,nn.data):G.texSubImage3D(Ie,Te,Ge,Et,an,Pe,we,Ue,Ot,bn,nn):w.isDataTexture?G.texSubImage2D(G.TEXTURE_2D,Te,Ge,Et,Pe,we,Ot,bn,nn.data):w.isCompressedTexture?G.compressedTexSubImage2D(G.TEXTURE_2D,Te,Ge,Et,nn.width,nn.height,Ot,nn.data):G.texSubImage2D(G.TEXTURE_2D,Te,Ge,Et,Pe,we,Ot,bn,nn);y.pixelStorei(G.UNPACK_ROW_LENGTH,Kn),y.pixelStorei(G.UNPACK_IMAGE_HEIGHT,gt),y.pixelStorei(G.UNPACK_SKIP_PIXELS,zn),y.pixelStorei(G.UNPACK_SKIP_ROWS,Jn),y.pixelStorei(G.UNPACK_SKIP_IMAGES,mi),Te===0&&W.generateMipmaps&&G.generateMipmap(Ie),y.unbindTexture()},this.initRenderTarget=function(w){K.get(w).__webglFramebuffer===void 0&&ee.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?ee.setTextureCube(w,0):w.isData3DTexture?ee.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?ee.setTexture2DArray(w,0):ee.setTexture2D(w,0),y.unbindTexture()},this.resetState=function(){$=0,H=0,ie=null,y.reset(),Ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ji}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=xt._getDrawingBufferColorSpace(e),t.unpackColorSpace=xt._getUnpackColorSpace()}};var xh=class{constructor(e){this.chain=e;let t=e.segments,i=Math.min(4,Math.max(1,Math.round(3600/Math.max(1,t)))),s=[];for(let r=0;r<t;){let o=r;for(;o+1<t&&e.diameter_m[o+1]===e.diameter_m[r]&&e.part[o+1]===e.part[r];)o++;let a=s.length,l=(o-r+1)*i;for(let c=0;c<=l;c++)s.push(r-.5+c/i);this.stretches.push({first:a,last:s.length-1,part:e.part[r]??0}),r=o+1}this.coordinate=Float32Array.from(s),this.rows=Math.max(1,Math.ceil(s.length/512)),this.texels=new Float32Array(this.rows*512*3*4),this.radius=new Float32Array(s.length);for(let{first:r,last:o}of this.stretches){let a=Math.min(t-1,Math.round(s[r]+.5));this.radius.fill(.5*(e.diameter_m[a]??.05),r,o+1)}this.arc=this.arcs()}chain;coordinate;arc;radius;stretches=[];texels;rows;get count(){return this.coordinate.length}arcs(){let e=new Float64Array(this.chain.segments+1);return this.chain.length_m.forEach((t,i)=>e[i+1]=e[i]+t),this.coordinate.map(t=>{let i=Math.min(this.chain.segments-1,Math.floor(t+.5));return e[i]+(t+.5-i)*(this.chain.length_m[i]??0)})}update(e,t){let{texels:i,coordinate:s}=this,r=this.chain.segments-1;for(let o=0;o<this.count;o++){let a=s[o],l=Math.min(Math.max(0,r-1),Math.max(0,Math.floor(a))),c=Math.min(r,l+1),u=Math.max(0,l-1),h=Math.min(r,c+1),d=a-l,f=12*o;for(let _=0;_<3;_++){let g=e[3*l+_],m=e[3*c+_];if(d<0||d>1){i[f+_]=g+d*(m-g);continue}let S=u<l?.5*(m-e[3*u+_]):m-g,C=h>c?.5*(e[3*h+_]-g):m-g,b=m-g;i[f+_]=g+d*(S+d*(3*b-2*S-C+d*(S+C-2*b)))}let p=Math.min(1,Math.max(0,d));i[f+3]=t[l]+p*(t[c]-t[l]),i[f+7]=this.radius[o],i[f+11]=this.arc[o]}for(let o of this.stretches)this.frame(o)}frame({first:e,last:t}){let i=this.texels,s=12,r=1,o=0,a=0,l=0,c=0,u=0;for(let h=e;h<=t;h++){let d=s*Math.max(e,h-1),f=s*Math.min(t,h+1),p=i[f]-i[d],_=i[f+1]-i[d+1],g=i[f+2]-i[d+2],m=Math.sqrt(p*p+_*_+g*g);m>1e-6&&(r=p/m,o=_/m,a=g/m);let S=l*r+c*o+u*a;l-=S*r,c-=S*o,u-=S*a;let C=Math.sqrt(l*l+c*c+u*u);if(C<.1){let R=Math.abs(a)>.9;S=R?r:a,l=(R?1:0)-S*r,c=-S*o,u=(R?0:1)-S*a,C=Math.sqrt(l*l+c*c+u*u)}l/=C,c/=C,u/=C;let b=s*h;i[b+4]=l,i[b+5]=c,i[b+6]=u,i[b+8]=r,i[b+9]=o,i[b+10]=a}}};var ex=()=>({factor:{value:1},pixel:{value:.001},reel:{value:new Qt(0,0,0,0)},reelAxis:{value:new z(0,1,0)},light:{value:new je(.62,.42)}}),na=`
uniform float factor;
uniform vec4 reel;
uniform vec3 reelAxis;
float spreadBy(vec3 place) {
  if (reel.w <= 0.0) return factor;
  vec3 r = place - reel.xyz;
  r -= dot(r, reelAxis) * reelAxis;
  return mix(1.0, factor, smoothstep(1.1, 2.5, length(r) / reel.w));
}
`,_r=`
uniform vec2 light;
vec3 lit(vec3 colour, vec3 normal, vec3 eye, float gloss) {
  vec3 lamp = normalize(vec3(-0.45, 0.75, 0.6));
  float sky = 0.5 + 0.5 * dot(normal, normalize((viewMatrix * vec4(0.0, 0.0, 1.0, 0.0)).xyz));
  float key = max(dot(normal, lamp), 0.0);
  float shine = pow(max(dot(normal, normalize(lamp + eye)), 0.0), 40.0);
  return colour * (light.x * (0.72 + 0.28 * sky) + light.y * key) + gloss * shine;
}
`;var Bi=12,cA=`
${na}
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
`,uA=`
${_r}
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
`;function hA({first:n,last:e},t,i,s){let r=i.length,o=(a,l,c,u)=>{let h=2*Math.PI*l/Bi;t.push(a,Math.cos(h),Math.sin(h),c),i.push(u)};for(let a=n;a<=e;a++)for(let l=0;l<Bi;l++)o(a,l,0,1);for(let a=0;a<e-n;a++)for(let l=0;l<Bi;l++){let c=r+a*Bi+l,u=r+a*Bi+(l+1)%Bi;s.push(c,u,c+Bi,u,u+Bi,c+Bi)}for(let a of[-1,1]){let l=a<0?n:e,c=i.length;o(l,0,a,0);for(let u=0;u<Bi;u++)o(l,u,a,1);for(let u=0;u<Bi;u++){let h=c+1+u,d=c+1+(u+1)%Bi;s.push(c,...a<0?[d,h]:[h,d])}}}var yh=class{mesh;rings;texture;constructor(e,t){this.rings=new xh(e);let{texels:i,rows:s}=this.rings;this.texture=new Wr(i,512*3,s,ai,Pi),this.texture.magFilter=this.texture.minFilter=vn;let r=new Wr(h0(256),256,1,ai);r.magFilter=r.minFilter=En,r.needsUpdate=!0;let o=[],a=[],l=[];for(let h of this.rings.stretches)hA(h,o,a,l);let c=new cn;c.setAttribute("corner",new Ft(o,4)),c.setAttribute("rim",new Ft(a,1)),c.setIndex(l);let u=new en({uniforms:{...t,rings:{value:this.texture},colours:{value:r},scale:{value:new je(0,1)},thinnest:{value:2},mark:{value:1},plain:{value:1}},vertexShader:cA,fragmentShader:uA,side:ji});this.mesh=new wt(c,u),this.mesh.frustumCulled=!1}update(e,t){this.rings.update(e,t),this.texture.needsUpdate=!0}scale(e){let t=this.mesh.material.uniforms;t.plain.value=e?0:1,e&&t.scale.value.set(e.low,e.high)}marks(e){this.mesh.material.uniforms.mark.value=e}centre(e){let t=12*e,i=this.rings.texels;return new z(i[t],i[t+1],i[t+2])}dispose(){this.texture.dispose(),this.mesh.material.uniforms.colours.value.dispose(),this.mesh.material.dispose(),this.mesh.geometry.dispose()}};var dA=`
${na}
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
`,fA=`
${_r}
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
`;function Ii(n){let{r:e,g:t,b:i}=new pt(n).convertLinearToSRGB();return new z(e,t,i)}function tx(n,e){let t=(e.opacity??1)<1;return new en({uniforms:{...n,colour:{value:Ii(e.colour)},opacity:{value:e.opacity??1}},vertexShader:dA,fragmentShader:fA,defines:e.smooth?{SMOOTH:""}:{},transparent:t,depthWrite:!t,depthTest:!e.onTop,side:$n})}var pA=400,mA=`
attribute vec3 base;
attribute float layer;
varying vec3 at;
varying float front;
varying float number;
void main() {
  vec4 inView = viewMatrix * modelMatrix * vec4(position, 1.0);
  vec3 foot = (viewMatrix * modelMatrix * vec4(base, 1.0)).xyz;
  at = inView.xyz;
  front = dot(at - foot, normalize(-foot));
  number = layer;
  gl_Position = projectionMatrix * inView;
  gl_PointSize = 2.0;
}
`,gA=`
${_r}
uniform vec3 colour;
uniform float fade;
uniform float cut;
varying vec3 at;
varying float front;
varying float number;
void main() {
  if (front > cut) discard;
  if (fract(52.9829189 * fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715)))) >= fade) discard;
  vec3 tint = colour * (1.0 + 0.12 * sin(number * vec3(2.4, 4.1, 5.3)));
#ifdef CLOUD
  gl_FragColor = vec4(tint, 1.0);
#else
  vec3 eye = normalize(-at);
  vec3 normal = normalize(cross(dFdx(at), dFdy(at)));
  gl_FragColor = vec4(lit(tint, dot(normal, eye) < 0.0 ? -normal : normal, eye, 0.0), 1.0);
#endif
}
`,vh=class{constructor(e,t,i){this.of=e;this.model=t;this.shared=i;this.shown=e.layers.map(()=>!0)}of;model;shared;group=new Ei;shown;drawn=[];materials=[];own={colour:{value:Ii("#888888")},fade:{value:1},cut:{value:0}};async unpack(){let{of:e,model:t}=this,[i,s,r]=await Promise.all([Ys(e.points,1,e.n_points,3),Ys(e.triangles,1,e.n_triangles,3),Ys(e.layer,1,e.n_triangles,1)]),o=Float32Array.from(i,(u,h)=>u*e.step_m-t.centre[h%3]),a=_A(o,t.path?.points??[]),l=u=>s[3*u]===s[3*u+1]&&s[3*u]===s[3*u+2],c=Array.from({length:e.n_triangles},(u,h)=>h).sort((u,h)=>r[u]-r[h]);this.add(c.filter(u=>!l(u)),3,o,a,s,r),this.add(c.filter(l),1,o,a,s,r),this.choose()}add(e,t,i,s,r,o){if(e.length===0)return;let a=t*e.length,l=p=>{let _=new Float32Array(3*a);for(let g=0;g<a;g++){let m=r[3*e[Math.floor(g/t)]+g%t];for(let S=0;S<3;S++)_[3*g+S]=p[3*m+S]}return _},c=new cn;c.setAttribute("position",new Tn(l(i),3)),c.setAttribute("base",new Tn(l(s),3));let u=Float32Array.from({length:a},(p,_)=>o[e[Math.floor(_/t)]]);c.setAttribute("layer",new Tn(u,1));let h=new Uint32Array(this.shown.length+1);for(let p of u)h[p+1]++;for(let p=0;p<this.shown.length;p++)h[p+1]+=h[p];let d=new en({uniforms:{...this.shared,...this.own},vertexShader:mA,fragmentShader:gA,defines:t===1?{CLOUD:""}:{},side:$n});this.materials.push(d),this.drawn.push({geometry:c,from:h});let f=t===1?new Ka(c,d):new wt(c,d);f.frustumCulled=!1,this.group.add(f)}choose(){for(let{geometry:e,from:t}of this.drawn){let i=this.shown.map((o,a)=>o?t[a+1]-t[a]:0),s=new Uint32Array(i.reduce((o,a)=>o+a,0)),r=0;i.forEach((o,a)=>{for(let l=0;l<o;l++)s[r++]=t[a]+l}),e.setIndex(new Tn(s,1))}}fade(e){this.own.fade.value=e,this.group.visible=e>0}cut(e){this.own.cut.value=e?0:1e9}recolour(e){this.own.colour.value=Ii(e)}dispose(){this.drawn.forEach(({geometry:e})=>e.dispose()),this.materials.forEach(e=>e.dispose())}};function _A(n,e){let t=Math.max(1,Math.ceil(e.length/pA)),i=e.filter((o,a)=>a%t===0||a===e.length-1),s=n.slice();if(i.length<2)return s;let r=Float64Array.from(i.flat());for(let o=0;o<n.length;o+=3){let[a,l,c]=[n[o],n[o+1],n[o+2]],u=1/0;for(let h=0;h+5<r.length;h+=3){let[d,f,p]=[r[h],r[h+1],r[h+2]],[_,g,m]=[r[h+3]-d,r[h+4]-f,r[h+5]-p],S=((a-d)*_+(l-f)*g+(c-p)*m)/(_*_+g*g+m*m),C=Math.min(1,Math.max(0,S)),[b,R,T]=[d+C*_,f+C*g,p+C*m],N=(a-b)**2+(l-R)**2+(c-T)**2;N>=u||(u=N,s[o]=b,s[o+1]=R,s[o+2]=T)}}return s}function yt(n,e){let t=n?.[e];return Array.isArray(t)?t.map(i=>typeof i=="number"&&Number.isFinite(i)?i:null):null}function xr(n,e){let t=n?.[e];return Array.isArray(t)?t.map(i=>String(i??"")):[]}function rn(n){return!!n&&n.some(e=>e!==null)}var xA={pull:"Tension in the cable",attachment:"Tension at eye or net",sidewall:"Sidewall pressure",bend_radius:"Bend radius of the cable",rope_bend:"Bend of the rope, over its diameter",roller_steady:"Roller load, steady",roller_peak:"Roller load, peak",rope:"Pull of the rope",winch:"Pull of the winch",push:"Force of a conveyor",buckling:"Push, against buckling",squeeze:"Clamp of a conveyor",run_away:"Brake that is missing",alpha:"Overload factor",trip:"Trip of the winch",speed:"Speed of the pull",jam_ratio:"Jam ratio",clearance:"Clearance in the duct",clearance_environment:"Clearance from the environment",fill:"Fill of the duct",weight_correction:"Weight correction factor",restart:"Restart from rest"};function Vn(n){let e=xA[n]??n.replaceAll("_"," ");return e.charAt(0).toUpperCase()+e.slice(1)}function Zr(n){return n.name.startsWith("clearance")?"mm":Ll(n.unit)?n.unit:"1"}function _l(n){return(n.summary.limits??[]).filter(t=>t.ok!==null&&t.margin!==null).sort((t,i)=>(t.margin??0)-(i.margin??0))}function yr(n,e){return n.summary.limits?.find(t=>t.name===e)??null}function Kr(n,...e){return e.flatMap(t=>{let i=yr(n,t)?.limit;return typeof i=="number"?[{label:`allowed (${Vn(t).toLowerCase()})`,value:i}]:[]})}function nx(n){return(n.summary.events??[]).map(e=>({x:e.time_s,label:e.what}))}function ix(n){let{from_s:e,to_s:t}=n.summary.steady_window??{};return typeof e=="number"&&typeof t=="number"&&t>e?{from:e,to:t,label:"steady window"}:void 0}function sx(n){return n.remedy??""}function xl(n){let e=n.summary.verdict??"";return e.startsWith("NOT TRUSTED")?"untrusted":e.startsWith("NOT SAFE")?"unsafe":e.startsWith("SAFE ONLY IF")?"conditional":e.startsWith("SAFE")?"safe":"unjudged"}function dp(n){return n.summary.title||n.summary.case||n.label}var rx=6;function yl(n,e,t,i=0){let s=new qn().setFromUnitVectors(new z(0,1,0),new z(...Nt(t,[0,1,0])));return n.translate(0,i,0),n.applyMatrix4(new Vt().makeRotationFromQuaternion(s)),n.translate(...e)}function ox(n,e,t){let i=e.at(n.center_m),{radius_m:s,width_m:r}=n,o=n.barrel_radius_m??.6*s,a=yl(new Ls(.985*o,.985*o,r,48),i,n.axis),l=[new wt(a,t("drum"))];for(let c of[-.5,.5]){let u=new Ls(s,s,.02*s,64),h=new wt(yl(u,i,n.axis,c*(r+.02*s)),t("drum",{opacity:.3}));h.renderOrder=1,l.push(h)}return l}function ax(n,e,t){let{radius_m:i,width_m:s}=n,r=new Ei,o=t("frame");for(let a of[-1,1])for(let l=0;l<rx;l++){let c=new ds(.05*i,.02*i,.97*i).translate(0,0,.485*i);c.rotateY(2*Math.PI*l/rx),r.add(new wt(yl(c,[0,0,0],n.axis,a*(.5*s+.03*i)),o))}return r.position.set(...e.at(n.center_m)),r}function lx(n,e){let t=n.geometry?.reel,i=yt(n.series,"time_s")?.map(c=>c??NaN),s=yt(n.series,"reel_speed_rad_per_s");if(!t||!i||!s||!e.path)return null;let r=vt(e.path.at(e.path.from),e.at(t.center_m)),o=Math.sign(Gn(Mi(Nt(t.axis),r),e.path.tangent(e.path.from)))||1,a=0,l=i.map((c,u)=>(u>0&&(a+=.5*((s[u]??0)+(s[u-1]??0))*(c-i[u-1])),o*a));return c=>ys(i,l,c)??0}function cx(n,e,t){let[i,s,r]=e.at(n.position_m),o=Nt([n.direction[0],n.direction[1],0],[1,0,0]),a=[-o[1],o[0],0],l=new qn().setFromUnitVectors(new z(0,1,0),new z(...a)),c=new ds(1.1,.9,.5).applyMatrix4(new Vt().makeRotationFromQuaternion(l));c.translate(i+.45*o[0],s+.45*o[1],r-.65);let u=yl(new Ls(.25,.25,.6,32),[i+.3*o[0],s+.3*o[1],r-.25],a);return[new wt(c,t("frame")),new wt(u,t("drum"))]}function ux({obstacles:n,rollers:e},t,i){return(n??[]).flatMap(s=>{let r=e[s.roller];if(!r)return[];let o=t.at(r.position_m),a=Nt(r.axis);if(s.ring_m!==null){let h=new Qa(s.ring_m,s.edge_m??.1,32,64);return[new wt(yl(h.rotateX(.5*Math.PI),o,a),i("obstacle",{opacity:.2}))]}let l=Nt(s.side,[0,1,0]),c=new Vt().makeBasis(new z(...a),new z(...l),new z(...Mi(a,l))),u=new ds(...s.size_m).applyMatrix4(c).translate(...o);return[new wt(u,i("obstacle"))]})}function yA(n,e){let t=[0,1,0];return n.map((i,s)=>{let r=Nt(vt(n[Math.min(n.length-1,s+1)],n[Math.max(0,s-1)])),o=Mi(e[s],r);return t=si(o)>.05?Nt(o):Nt(Bt(t,r,-Gn(t,r)),t),{left:t,above:Mi(r,t)}})}function hx({line:n,base:e,profile:t,closed:i,ups:s,widen:r=0}){let o=[],a=[],l=[],c=[],u=[],h=yA(n,s),d=t.length;n.forEach((p,_)=>{let{left:g,above:m}=h[_],S=Gn(vt(p,e[_]),m),C=Bt(p,m,-S);for(let{across:b,above:R,wide:T=0}of t)o.push(...C),a.push(...Bt(Bt([0,0,0],g,b),m,S+R)),l.push(...Bt([0,0,0],g,T)),c.push(...Nt(Bt(Bt([0,0,0],g,b),m,R),m));if(_!==0)for(let b=0;b<(i?d:d-1);b++){let R=(_-1)*d+b,T=(_-1)*d+(b+1)%d;u.push(R,T,R+d,T,T+d,R+d)}});let f=new cn;return f.setAttribute("position",new Ft(o,3)),f.setAttribute("offset",new Ft(a,3)),f.setAttribute("side",new Ft(l,3)),f.setAttribute("normal",new Ft(c,3)),f.setAttribute("widen",new Ft(new Float32Array(o.length/3).fill(r),1)),f.setIndex(u),f}var dx=(n,e)=>Array.from({length:e},(t,i)=>{let s=2*Math.PI*i/e;return{across:n*Math.cos(s),above:n*Math.sin(s)}}),fx=(n,e,t,i)=>[{across:n,above:t},{across:n+e,above:t},{across:n+e,above:i},{across:n,above:i}];function px(n,e,t){let i={line:n.slice(0,1),ups:e.slice(0,1)};for(let s=1;s<n.length;s++){let[r,o]=[n[s-1],n[s]],a=Math.min(400,Math.max(1,Math.ceil(si(vt(o,r))/t)));for(let l=1;l<=a;l++)i.line.push(Bt(r,vt(o,r),l/a)),i.ups.push(Bt(e[s-1],vt(e[s],e[s-1]),l/a))}return i}var vA=28,mx=1,bA=1.8,gx=.6,bh={width:.1,height:.22},Mh=class{constructor(e,t,i){this.model=e;this.shared=t;let s=e.run.geometry;if(this.angle=lx(e.run,e),!s)return;this.route(i);for(let a of s.surfaces)this.surface(a);for(let a of s.conveyors)this.conveyor(a);let r=(a,l={})=>this.paint(a,l),o=[...s.reel?ox(s.reel,e,r):[],...s.winch?cx(s.winch,e,r):[],...ux(s,e,r)];for(let a of o)this.group.add(a);s.reel&&this.group.add(this.spokes=ax(s.reel,e,r))}model;shared;group=new Ei;cast=null;spokes=null;angle;painted=[];turn(e){let t=this.model.run.geometry?.reel?.axis;!t||!this.angle||this.spokes?.quaternion.setFromAxisAngle(new z(...Nt(t,[0,1,0])),this.angle(e))}paint(e,t){let i=tx(this.shared,{colour:"#888888",...t});return this.painted.push({material:i,part:e}),i}route(e){let t=this.model.path?.points??[],i=(s,r,o)=>{let a=new cn;a.setAttribute("position",new Ft(s.flat(),3));let l=new qo({transparent:!0,opacity:o});this.painted.push({material:l,part:r});let c=new $o(a,l);return this.group.add(c),c};i(t,"route",.7),this.cast=i(t.map(([s,r])=>[s,r,e]),"grid",.4)}swept(e,t,i,s,r=0){let{line:o,ups:a}=px(e,s?.length===e.length?s:e.map(()=>[0,0,1]),mx),l=this.model.path,c=o.map(u=>{let h=l?.nearest(u);return l&&h&&h.distance<3?l.at(h.s):u});return hx({line:o,base:c,profile:t,closed:i,ups:a,widen:r})}surface(e){let t=e.points_m.map(this.model.at);if(t.length<2)return;let i=e.kind==="duct"&&e.diameter_m,s=i?this.swept(t,dx(.5*i,vA),!0,e.up):this.swept(t,MA(e),!1,e.up??t.map(()=>e.normal??[0,0,1]),this.widening(e)),r=i?this.paint("duct",{opacity:.13,smooth:!0}):this.paint("floor",{opacity:.55}),o=new wt(s,r);o.renderOrder=i?2:1,this.group.add(o)}widening(e){return bA*this.model.diameter/(e.width_m??gx)}conveyor(e){let{path:t,at:i}=this.model,{from_m:s,to_m:r}=e,o=Math.max(2,Math.ceil((r-s)/mx)+1),a=t?Array.from({length:o},(c,u)=>t.at(s+(r-s)*u/(o-1))):e.points_m.map(i);if(a.length<2)return;let l=.5*this.model.diameter;for(let c of[l,-l-bh.width]){let u=fx(c,bh.width,-.5*bh.height,.5*bh.height);this.group.add(new wt(this.swept(a,u,!0),this.paint("belt",{})))}}shadow(e){this.cast&&(this.cast.visible=e)}recolour(e){for(let{material:t,part:i}of this.painted)t instanceof en?t.uniforms.colour.value=Ii(e[i]):t.color.set(e[i])}dispose(){this.group.traverse(e=>{(e instanceof wt||e instanceof $o)&&e.geometry.dispose()});for(let{material:e}of this.painted)e.dispose()}};function MA({width_m:n,height_m:e,section:t}){let i=.5*(n??gx),s=e??0;return t==="v"?[-i,0,i].map(r=>({across:r,above:s*Math.abs(r)/i})):s>0?[{across:-i,above:s},{across:-i,above:0},{across:i,above:0},{across:i,above:s}]:[i,-i].map(r=>({across:0,above:0,wide:r}))}function fp(n){let e=n.reduce((i,s)=>Math.min(i,s[2]),1/0),t=i=>{let s=n.map(r=>r[i]);return s.reduce((r,o)=>Math.max(r,o),-1/0)-s.reduce((r,o)=>Math.min(r,o),1/0)};return Number.isFinite(e)?e-Math.max(1,.008*Math.hypot(t(0),t(1))):-1}var SA=`
varying vec2 place;
void main() {
  place = position.xy;
  gl_Position = projectionMatrix * viewMatrix * modelMatrix * vec4(position, 1.0);
}
`,wA=`
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
`,Sh=class{mesh;spacing=1;constructor(e,t){let i=new en({uniforms:{colour:{value:Ii("#888")},spacing:{value:1},focus:{value:new z(0,0,t)}},vertexShader:SA,fragmentShader:wA,transparent:!0,depthWrite:!1,side:$n});this.mesh=new wt(new Xr(2*t,2*t),i),this.mesh.position.z=e,this.mesh.renderOrder=-1}follow(e,t,i,s){let r=i/14/s,o=10**Math.floor(Math.log10(r));this.spacing=s*o*(r/o>5?10:r/o>2?5:2);let a=this.mesh.material.uniforms;a.spacing.value=this.spacing,a.focus.value.set(e,t,1.6*i)}recolour(e){this.mesh.material.uniforms.colour.value=Ii(e)}dispose(){this.mesh.geometry.dispose(),this.mesh.material.dispose()}};var Jr=n=>({x:new Float32Array(n),y:new Float32Array(n),depth:new Float32Array(n)});function ia(n,e,t,i,s){let r=c=>[e[c],e[c+4],e[c+8],e[c+12]],[o,a,l]=[r(0),r(1),r(3)];for(let c=0;c<s.x.length;c++){let u=n[3*c],h=n[3*c+1],d=n[3*c+2],f=l[0]*u+l[1]*h+l[2]*d+l[3];s.depth[c]=f,s.x[c]=(.5+.5*(o[0]*u+o[1]*h+o[2]*d+o[3])/f)*t,s.y[c]=(.5-.5*(a[0]*u+a[1]*h+a[2]*d+a[3])/f)*i}}function _x(n,e,t,i){let s=-1,r=1/0;for(let o=0;o<n.x.length;o++){let a=n.depth[o];if(a<=0)continue;let c=Math.hypot(n.x[o]-e,n.y[o]-t)/i(a);c<1&&c*(.2+a)<r&&(r=c*(.2+a),s=o)}return s}function xx(n,e,t,i){let s=null;for(let r=0;r+1<n.x.length;r++){if(n.depth[r]<=0||n.depth[r+1]<=0)continue;let o=n.x[r+1]-n.x[r],a=n.y[r+1]-n.y[r],l=o*o+a*a,c=l>0?((e-n.x[r])*o+(t-n.y[r])*a)/l:0,u=Math.min(1,Math.max(0,c)),h=Math.hypot(n.x[r]+u*o-e,n.y[r]+u*a-t);h<=i&&(!s||h<s.pixels)&&(s={index:r+u,pixels:h})}return s}function TA(n){let e=n.map((s,r)=>r).sort((s,r)=>n[r].weight-n[s].weight),t=[],i=new Array(n.length).fill(!1);for(let s of e){let r=n[s];!t.every(a=>Math.abs(r.x-a.x)*2>=r.width+a.width||Math.abs(r.y-a.y)*2>=r.height+a.height)&&r.weight<100||(i[s]=!0,t.push(r))}return i}var yx=6.6,EA=20,vx=16,wh=class{root=A("div",{class:"view-labels","aria-hidden":"true"});elements=new Map;screen=Jr(0);points=new Float32Array(0);set(e,t){let i=this.elements.get(e);if(!t){i?.element.remove(),this.elements.delete(e);return}if(i&&i.label.text===t.text&&i.label.kind===t.kind){i.label=t;return}let s=i?.element??A("span");s.className=`view-label view-label-${t.kind}`,s.replaceChildren(A("b",{},t.text),A("i")),i||this.root.append(s),this.elements.set(e,{element:s,label:t})}shown(){return[...this.elements.values()].flatMap(({element:e,label:t},i)=>e.hidden?[]:[{text:t.text,x:this.screen.x[i],y:this.screen.y[i],aside:parseFloat(e.style.getPropertyValue("--aside"))||0}])}update(e,t,i){let s=[...this.elements.values()];this.screen.x.length!==s.length&&(this.screen=Jr(s.length),this.points=new Float32Array(3*s.length)),s.forEach(({label:u},h)=>this.points.set(u.point,3*h)),ia(this.points,e.elements,t,i,this.screen);let{x:r,y:o,depth:a}=this.screen,l=s.map((u,h)=>a[h]>0&&r[h]>0&&r[h]<t&&o[h]>vx&&o[h]<i),c=TA(s.map(({label:u},h)=>({x:l[h]?r[h]:-1e6*(h+1),y:l[h]?o[h]-vx:0,width:yx*u.text.length+14,height:EA,weight:u.weight})));s.forEach(({element:u},h)=>{let d=l[h]&&c[h];if(u.hidden=!d,!d)return;let f=.5*(yx*s[h].label.text.length+14),p=Math.min(Math.max(r[h],f),t-f);u.style.setProperty("--aside",`${(p-r[h]).toFixed(0)}px`),u.style.transform=`translate(${r[h].toFixed(1)}px, ${o[h].toFixed(1)}px)`})}};var bx={light:{ground:"#f4f6f8",grid:"#9aa7b4",route:"#5c6b7a",duct:"#4a78a8",floor:"#b9b1a2",belt:"#3f5f68",steel:"#b3bdc7",drum:"#b98d5e",frame:"#59636e",obstacle:"#b0532f",environment:"#cfd4da"},dark:{ground:"#12171d",grid:"#465362",route:"#8796a6",duct:"#7fb0e6",floor:"#5b574f",belt:"#6f97a2",steel:"#6b7783",drum:"#a87f54",frame:"#98a4b0",obstacle:"#d9774f",environment:"#46515d"}};var AA=.1,CA=.4,RA=2,PA=2.2,IA=.42,LA=`
${na}
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
`,NA=`
${_r}
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
`,Mx=({kind:n})=>n!=="box"&&n!=="bell-mouth";function DA(n,e,t){let i=n?.nearest(e);if(!n||!i||i.distance>RA||i.distance<1e-6)return{base:e,away:[0,0,-1],gap:-t};let s=n.at(i.s);return{base:s,away:Nt(vt(e,s)),gap:i.distance-t}}var Th=class{mesh;centres;stand;constructor(e,{at:t,path:i,diameter:s},r){let o=FA(e);this.stand=e.map(h=>{let d=Mx(h)?h.radius_m??AA:0;return{...DA(i,t(h.position_m),d),radius:d,largest:d>0?IA*o:0}}),this.centres=new Float32Array(3*e.length);let a=new Ls(1,1,1,20),l=new il;l.index=a.index,l.setAttribute("position",a.getAttribute("position")),l.setAttribute("normal",a.getAttribute("normal"));let c=(h,d,f)=>{let p=new Float32Array(d*e.length);e.forEach((_,g)=>p.set(f(_,g),d*g)),l.setAttribute(h,new Ya(p,d))};c("base",3,(h,d)=>this.stand[d].base),c("away",4,(h,d)=>[...this.stand[d].away,this.stand[d].gap]),c("axis",3,h=>Nt(h.axis,[0,1,0])),c("measure",4,(h,d)=>[this.stand[d].radius,Mx(h)?h.width_m??CA:0,this.stand[d].largest,d]),l.instanceCount=e.length;let u=new en({uniforms:{...r,widest:{value:PA*s},colour:{value:Ii("#8d99a6")},pickedColour:{value:Ii("#e8590c")},picked:{value:-1},hovered:{value:-1}},vertexShader:LA,fragmentShader:NA});this.mesh=new wt(l,u),this.mesh.frustumCulled=!1,this.place(1)}place(e){this.stand.forEach(({base:t,away:i,gap:s,radius:r,largest:o},a)=>{let l=Math.max(r,Math.min(e*r,o));this.centres.set(Bt(t,i,e*s+l),3*a)})}centre(e){return[this.centres[3*e],this.centres[3*e+1],this.centres[3*e+2]]}drawnRadius(e,t){let{radius:i,largest:s}=this.stand[e];return Math.max(i,Math.min(t*i,s))}mark(e,t){this.mesh.material.uniforms.picked.value=e,this.mesh.material.uniforms.hovered.value=t}recolour(e){this.mesh.material.uniforms.colour.value=Ii(e)}dispose(){this.mesh.geometry.dispose(),this.mesh.material.dispose()}};function FA(n){let e=n.map(s=>s.s_m).filter(s=>s!==null);e.sort((s,r)=>s-r);let i=e.slice(1).map((s,r)=>s-e[r]).filter(s=>s>.001).sort((s,r)=>s-r);return i[Math.floor(i.length/2)]??1/0}var Sx={type:"change"},mp={type:"start"},Tx={type:"end"},Eh=new or,wx=new ki,UA=Math.cos(70*Wf.DEG2RAD),Rn=new z,di=2*Math.PI,Ht={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},pp=1e-6,Ah=class extends sl{constructor(e,t=null){super(e,t),this.state=Ht.NONE,this.target=new z,this.cursor=new z,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:ur.ROTATE,MIDDLE:ur.DOLLY,RIGHT:ur.PAN},this.touches={ONE:hr.ROTATE,TWO:hr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new z,this._lastQuaternion=new qn,this._lastTargetPosition=new z,this._quat=new qn().setFromUnitVectors(e.up,new z(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Yo,this._sphericalDelta=new Yo,this._scale=1,this._panOffset=new z,this._rotateStart=new je,this._rotateEnd=new je,this._rotateDelta=new je,this._panStart=new je,this._panEnd=new je,this._panDelta=new je,this._dollyStart=new je,this._dollyEnd=new je,this._dollyDelta=new je,this._dollyDirection=new z,this._mouse=new je,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=kA.bind(this),this._onPointerDown=OA.bind(this),this._onPointerUp=BA.bind(this),this._onContextMenu=qA.bind(this),this._onMouseWheel=GA.bind(this),this._onKeyDown=HA.bind(this),this._onTouchStart=WA.bind(this),this._onTouchMove=XA.bind(this),this._onMouseDown=VA.bind(this),this._onMouseMove=zA.bind(this),this._interceptControlDown=$A.bind(this),this._interceptControlUp=YA.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction=""}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Sx),this.update(),this.state=Ht.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Rn.copy(t).sub(this.target),Rn.applyQuaternion(this._quat),this._spherical.setFromVector3(Rn),this.autoRotate&&this.state===Ht.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=di:i>Math.PI&&(i-=di),s<-Math.PI?s+=di:s>Math.PI&&(s-=di),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Rn.setFromSpherical(this._spherical),Rn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Rn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Rn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new z(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new z(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Rn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Eh.origin.copy(this.object.position),Eh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Eh.direction))<UA?this.object.lookAt(this.target):(wx.setFromNormalAndCoplanarPoint(this.object.up,this.target),Eh.intersectPlane(wx,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>pp||8*(1-this._lastQuaternion.dot(this.object.quaternion))>pp||this._lastTargetPosition.distanceToSquared(this.target)>pp?(this.dispatchEvent(Sx),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?di/60*this.autoRotateSpeed*e:di/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Rn.setFromMatrixColumn(t,0),Rn.multiplyScalar(-e),this._panOffset.add(Rn)}_panUp(e,t){this.screenSpacePanning===!0?Rn.setFromMatrixColumn(t,1):(Rn.setFromMatrixColumn(t,0),Rn.crossVectors(this.object.up,Rn)),Rn.multiplyScalar(e),this._panOffset.add(Rn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Rn.copy(s).sub(this.target);let r=Rn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientX),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(di*this._rotateDelta.x/t.clientHeight),this._rotateUp(di*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(di*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-di*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(di*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-di*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(di*this._rotateDelta.x/t.clientHeight),this._rotateUp(di*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new je,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function OA(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function kA(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function BA(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Tx),this.state=Ht.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function VA(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case ur.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ht.DOLLY;break;case ur.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ht.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ht.ROTATE}break;case ur.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ht.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ht.PAN}break;default:this.state=Ht.NONE}this.state!==Ht.NONE&&this.dispatchEvent(mp)}function zA(n){switch(this.state){case Ht.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ht.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ht.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function GA(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ht.NONE||(n.preventDefault(),this.dispatchEvent(mp),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Tx))}function HA(n){this.enabled!==!1&&this._handleKeyDown(n)}function WA(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case hr.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(n),this.state=Ht.TOUCH_ROTATE;break;case hr.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(n),this.state=Ht.TOUCH_PAN;break;default:this.state=Ht.NONE}break;case 2:switch(this.touches.TWO){case hr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ht.TOUCH_DOLLY_PAN;break;case hr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ht.TOUCH_DOLLY_ROTATE;break;default:this.state=Ht.NONE}break;default:this.state=Ht.NONE}this.state!==Ht.NONE&&this.dispatchEvent(mp)}function XA(n){switch(this._trackPointer(n),this.state){case Ht.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ht.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ht.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ht.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ht.NONE}}function qA(n){this.enabled!==!1&&n.preventDefault()}function $A(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function YA(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var ZA=.7,KA=2,Ex=n=>[n.x,n.y,n.z],Ch=class{constructor(e,t,i){this.root=e;this.shared=t;this.still=i;this.renderer=new mh({antialias:!0,preserveDrawingBuffer:!0}),this.renderer.setPixelRatio(Math.min(KA,window.devicePixelRatio)),e.prepend(this.renderer.domElement),this.camera.up.set(0,0,1),this.controls=new Ah(this.camera,this.renderer.domElement),this.controls.zoomToCursor=!0,this.controls.zoomSpeed=1.6,this.controls.addEventListener("change",()=>this.invalidate()),this.controls.addEventListener("start",()=>this.flight=null),this.observer=new ResizeObserver(()=>this.resize()),this.observer.observe(e),this.resize()}root;shared;still;scene=new Wa;camera=new Xn(35,1,.1,1e3);renderer;controls;clip=new Vt;onFrame=()=>!1;spent={update:0,render:0};flight=null;request=0;last=0;radius=100;observer;get width(){return Math.max(1,this.root.clientWidth)}get height(){return Math.max(1,this.root.clientHeight)}get aspect(){return this.width/this.height}get pose(){return{position:Ex(this.camera.position),target:Ex(this.controls.target),fov:this.camera.fov}}get distance(){return this.camera.position.distanceTo(this.controls.target)}resize(){this.renderer.setSize(this.width,this.height,!1),this.camera.aspect=this.aspect,this.invalidate()}reach(e){this.radius=e}go(e,t=!1){t||this.still?(this.flight=null,this.stand(e)):this.flight={from:this.pose,to:e,part:0},this.invalidate()}get goal(){return this.flight?.to??this.pose}zoom(e){let t=this.goal;this.go(Eo(t,t.target,si(vt(t.position,t.target))*e))}orbit(e,t){let{position:i,target:s,fov:r}=this.goal,o=new z(...vt(i,s)),a=Math.hypot(o.x,o.y),l=Math.atan2(o.z,a)+t*Math.PI/180,c=Math.atan2(o.y,o.x)+e*Math.PI/180,u=o.length(),h=Math.min(1.569,Math.max(-1.569,l)),d=u*Math.cos(h),f=[d*Math.cos(c),d*Math.sin(c),u*Math.sin(h)];this.go({position:[s[0]+f[0],s[1]+f[1],s[2]+f[2]],target:s,fov:r},!0)}shift(e){if(this.camera.position.add(new z(...e)),this.controls.target.add(new z(...e)),this.flight)for(let t of[this.flight.from,this.flight.to])for(let i of[t.position,t.target])i.forEach((s,r)=>i[r]=s+e[r])}stand(e){this.camera.position.set(...e.position),this.controls.target.set(...e.target),this.camera.fov=e.fov,this.controls.update()}invalidate(){this.request||=requestAnimationFrame(e=>this.frame(e))}frame(e){this.request=0;let t=this.last>0?(e-this.last)/1e3:0;if(this.flight){this.flight.part=Math.min(1,this.flight.part+Math.min(t,.1)/ZA);let{from:o,to:a,part:l}=this.flight;this.stand(Hg(o,a,l)),l>=1&&(this.flight=null)}let i=performance.now();this.fit();let s=this.onFrame(t)||this.flight!==null,r=performance.now();this.renderer.render(this.scene,this.camera),this.spent={update:r-i,render:performance.now()-r},this.last=s?e:0,s&&this.invalidate()}shot(e){let{renderer:t}=this,i=t.getPixelRatio();t.setPixelRatio(e),this.fit(),this.onFrame(0),t.render(this.scene,this.camera);let s=t.domElement.toDataURL("image/png");return t.setPixelRatio(i),this.invalidate(),s}fit(){let e=this.camera,t=e.position.length()+1.5*this.radius+10;e.near=Math.max(.02*this.distance,t*2e-5,.01),e.far=t,e.updateProjectionMatrix(),e.updateMatrixWorld(),this.clip.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this.shared.pixel.value=2*Math.tan(e.fov*Math.PI/360)/this.height}dispose(){cancelAnimationFrame(this.request),this.observer.disconnect(),this.controls.dispose(),this.renderer.dispose(),this.renderer.forceContextLoss(),this.renderer.domElement.remove()}};var JA=5,jA=100,QA=55,eC=[1,2,5,10,20,50,100,200,500],tC=.5,nC=9,iC=12,Rh=class{constructor(e,t,i,s){this.model=t;this.beside=s;this.stage=new Ch(e,this.shared,i),e.append(this.labels.root);let{run:r,path:o,extent:a}=t,l=this.wide=a.reduce((p,_)=>Math.max(p,si(_)),10),c=fp(a);this.ground=new Sh(c,6*l),this.equipment=new Mh(t,this.shared,c+.001),this.chains=[t,...s.models].map(({chain:p})=>p?new yh(p,this.shared):null);let u=r.geometry?.rollers??[];this.rollers=u.length>0?new Th(u,t,this.shared):null;let h=r.geometry?.reel;h&&(this.shared.reel.value.set(...t.at(h.center_m),h.radius_m),this.shared.reelAxis.value.set(...Bd(h.axis)));let{scene:d}=this.stage;d.add(this.ground.mesh,this.equipment.group),this.rollers&&d.add(this.rollers.mesh);for(let p of this.chains)p&&(p.mesh.visible=!1,d.add(p.mesh));let f=r.environment;this.environment=f&&f.n_triangles>0?new vh(f,t,this.shared):null,this.environment&&d.add(this.environment.group),this.stage.reach(6*l),this.routePoints=Float32Array.from((o?.points??[]).flat()),this.routeScreen=Jr(o?.points.length??0),this.rollerScreen=Jr(u.length)}model;beside;stage;labels=new wh;chains;rollers;ground;environment;shared=ex();equipment;routePoints;routeScreen;rollerScreen;wide;unit=1;asked=null;get factor(){return this.shared.factor.value}exaggerate(e){this.asked=e,this.stage.invalidate()}paint(e){let t=bx[e];this.stage.renderer.setClearColor(t.ground),this.equipment.recolour(t),this.rollers?.recolour(t.steel),this.ground.recolour(t.grid),this.environment?.recolour(t.environment),this.shared.light.value.set(e==="dark"?.6:.68,.42),this.stage.invalidate()}scale(e){for(let t of this.chains)t?.scale(e);this.stage.invalidate()}update(e){let{stage:t}=this,i=this.shared.pixel.value*t.distance,s=Math.min(jA,Math.max(1,JA*i/this.model.diameter)),r=this.beside.models.length>0||this.environment?1:s;this.shared.factor.value=this.asked??r;let{target:o}=t.controls;this.ground.follow(o.x,o.y,t.distance,this.unit),this.ground.mesh.position.z=this.groundHeight(),this.equipment.shadow(t.distance>tC*this.wide);let a=eC.find(l=>l/i>QA)??1e3;for(let l of this.chains)l?.marks(a);e&&this.equipment.turn(e.time),e&&[e,...this.beside.nows].forEach((l,c)=>{let u=this.chains[c];!l||!u||(u.update(l.centres,l.values),u.mesh.visible=!0)})}groundHeight(){let{target:e}=this.stage.controls,t=2*this.stage.distance,i=this.model.extent.filter(([s,r])=>Math.hypot(s-e.x,r-e.y)<t);return fp(i.length>0?i:this.model.extent)}updateLabels(){this.labels.update(this.stage.clip,this.stage.width,this.stage.height)}rollerAt(e,t){let i=this.rollers;if(!i)return-1;let{stage:s,factor:r}=this;i.place(r),ia(i.centres,s.clip.elements,s.width,s.height,this.rollerScreen);let o=this.shared.pixel.value,a=i.drawnRadius(0,r);return _x(this.rollerScreen,e,t,l=>Math.max(nC,a/(o*l)))}placeAt(e,t){let{stage:i,model:s}=this;if(!s.path)return null;ia(this.routePoints,i.clip.elements,i.width,i.height,this.routeScreen);let r=.5*s.diameter*this.factor/(this.shared.pixel.value*i.distance),o=xx(this.routeScreen,e,t,Math.max(iC,1.2*r));if(!o)return null;let a=Math.min(s.path.points.length-2,Math.floor(o.index)),{s:l}=s.path;return l[a]+(o.index-a)*(l[a+1]-l[a])}onScreen(e){let t=Jr(1);return ia(e,this.stage.clip.elements,this.stage.width,this.stage.height,t),{x:t.x[0],y:t.y[0]}}dispose(){for(let e of this.chains)e?.dispose();this.rollers?.dispose(),this.equipment.dispose(),this.ground.dispose(),this.environment?.dispose(),this.labels.root.remove(),this.stage.dispose()}};var sC="This browser does not draw in three dimensions here (no WebGL). Times and figures below still work, and everything is in the figures of this page.",rC="These results hold no states (results.h5), so nothing moves.";function oC(){let n=Jg.flatMap(([t,i])=>[A("span",{},A("kbd",{},t),` ${i}`)," "]);return A("details",{class:"view-help"},A("summary",{},"Space plays, \u2190 \u2192 step, + \u2212 zoom, 1\u20139 move the camera, F follows the head; all keys and the mouse"),A("p",{},"Drag turns, the right button moves, the wheel zooms once the picture has been clicked. A click on a roller or the cable shows its figures over time, a double click goes there."),A("p",{},...n))}function aC(n,e){let t=window.matchMedia("(prefers-reduced-motion: reduce)").matches;try{return new Rh(n,e.model,t,e.beside)}catch(i){return console.info(i),n.classList.add("view-stage-empty"),n.prepend(A("p",{class:"view-notice",role:"note"},sC)),null}}function lC(n,e,t){let i=n.stage.renderer.domElement,s=-1,r=o=>{if(o===s)return;s=o;let a=t.get("roller")??-1;n.rollers?.mark(a,o),e.hover(o)};return r0(i,{hover:(o,a)=>{let l=n.rollerAt(o,a);r(l);let c=l>=0?e.model.run.geometry?.rollers[l]?.s_m??null:n.placeAt(o,a);i.style.cursor=l>=0||c!==null?"pointer":"",t.set("place",c)},leave:()=>{r(-1),t.set("place",null)},click:(o,a)=>{i.focus({preventScroll:!0});let l=n.rollerAt(o,a),c=n.placeAt(o,a);e.inspect(l>=0?{roller:l}:c!==null?{place:c}:null)},double:(o,a)=>{e.toPlace(n.placeAt(o,a))}})}function Ph(n,e,t,i=[]){let s=A("p"),r=A("p",{class:"view-spoken","aria-live":"polite"}),o=new xc(e,t,new oc(s,r),i),a=A("div",{class:"view-stage"}),l=A("div",{class:"view3d",role:"group","aria-label":"The pull in three dimensions"},o.tools.root,a,o.player.root,A("div",{class:"view-words"},s,r,oC()));n.replaceChildren(l);let c=[],u=null,h=aC(a,o);if(h){o.draws(h,new nc(h,()=>o.now,()=>o.playback.time)),a.append(o.legend.root,o.inspector.root);let{environment:p}=h;if(p){let g=new lc(p.of,p,()=>h.stage.invalidate());u=g,o.tools.root.append(g.root)}let _=h.stage.renderer.domElement;_.tabIndex=0,_.setAttribute("role","img"),_.setAttribute("aria-label","Route, rollers and cable; keys and a sentence on what is to be seen are below"),h.stage.controls.enableZoom=!1,_.addEventListener("focus",()=>h.stage.controls.enableZoom=!0),_.addEventListener("blur",()=>h.stage.controls.enableZoom=!1),c.push(lC(h,o,t))}let d=()=>{l.dataset.theme=t.get("theme"),o.redress(),u?.units(t.get("units"))};return c.push(jg(l,o),t.subscribe("units",d),t.subscribe("theme",d),t.subscribe("place",()=>o.mark()),t.subscribe("time",(p,_)=>{_!==o&&p!==null&&o.showAt(p)}),t.subscribe("roller",(p,_)=>{_!==o&&o.inspect(p===null?null:{roller:p})})),d(),o.preset(0,!0),{ready:uC(e,o,s),viewer:o,onPaper:()=>s0(o,t),dispose:()=>{c.forEach(p=>p()),o.dispose(),n.replaceChildren()}}}async function cC(n,e){let{world:t,model:i}=n;try{await t?.environment?.unpack(),t?.stage.invalidate()}catch(r){e.after(A("p",{},`The environment cannot be shown: ${r instanceof Error?r.message:String(r)}.`))}let s=i.run.environment;s&&s.n_triangles===0&&e.after(A("p",{},`The environment is not shown: its ${s.given} triangles are more than this build can simplify.`))}async function uC(n,e,t){if(await cC(e,t),!n.states||n.states.frames===0){t.textContent=rC;return}t.textContent="Unpacking the states\u2026";try{await Dd(n.states,(i,s)=>e.arrived(i,s));for(let[i,{states:s}]of e.beside.runs.entries())s&&s.frames>0&&await Dd(s,r=>e.besideArrived(i,r));e.forces=await e0(n),e.inspectAgain()}catch(i){t.textContent=`The states cannot be shown: ${i instanceof Error?i.message:String(i)}.`}}var hC=600,dC=4e6,fC=.25,pC=1e3,gp={position:{components:3,unit:"m",step:.001},tension:{components:1,unit:"N",step:1}},mC=n=>Number.isFinite(n)?n:null,Ih=class{constructor(e,t){this.name=e;this.row=t}name;row;q=new Int32Array(0);put(e,t){if((e+1)*this.row>this.q.length){let r=new Int32Array(2*(e+1)*this.row);r.set(this.q),this.q=r}let{step:i}=gp[this.name],s=e*this.row;for(let r=0;r<this.row;r++)this.q[s+r]=Math.round(t[r]/i)}move(e,t){this.q.copyWithin(t*this.row,e*this.row,(e+1)*this.row)}};function Ax(n,e,t,i){let s=e.runs[0];if(!s)throw new Error("There is no run.");Kh(s);let r=s.chain?.segments??0;s.states={frames:0,segments:r,time_s:[],head_at_m:[],fields:gp,packed:{position:"",tension:""}},document.documentElement.dataset.theme=i;let o=new wo({place:null,time:null,units:t,theme:i,run:0,roller:null}),a=A("div",{class:"view"}),l=A("div",{class:"live-figure"});n.replaceChildren(l,a);let c=Ph(a,s,o),u={zoom:null,hidden:new Set,open:!1},h=[],d=[new Ih("position",3*r),new Ih("tension",r)],f=Math.max(20,Math.min(hC,Math.floor(dC/Math.max(1,4*r)))),p=1,_=0,g=null,m=-1/0;function S(){let N=h.map(U=>U.time),v=(U,k,X)=>({label:U,role:k,x:N,y:h.map(O=>mC(X(O)))}),E=g;E?.element.removeAttribute("id"),g=new So({id:"live",title:"Force at the winch so far",caption:"Forces of the run that is being computed, and what theory expects.",along:"time",xLabel:"time",yLabel:"force",yUnit:"N",fromZero:!0,curves:[v("winch","simulated",U=>U.force),v("largest tension anywhere","second",U=>U.most),v("expected by theory","theory",U=>U.reference)].filter(U=>U.y.some(k=>k!==null))},o,u);let{element:F}=g;l.append(F);let I=()=>{if(!F.querySelector("canvas"))return void requestAnimationFrame(I);E?.dispose(),l.replaceChildren(F)};I()}let C=-1/0,b=!1;function R(){let N=performance.now();if(b||N<C||r===0)return;b=!0;let v=new Fr(h.map(E=>E.time),r);for(let{name:E,q:F}of d){let I=gp[E];v.fields.set(E,{meta:I,q:F.subarray(0,h.length*r*I.components)})}c.viewer.grown(v),requestAnimationFrame(()=>setTimeout(()=>{b=!1;let E=performance.now();C=E+(E-N)*(1/fC-1)}))}function T({position:N,tension:v,...E}){let F=h[h.length-1];if(F&&E.time<F.time&&(h=[]),F&&E.time===F.time&&h.pop(),!(_++%p!==0||N.length!==3*r)&&(d.forEach(I=>I.put(h.length,I.name==="position"?N:v)),h.push(E),!(h.length<=f))){h=h.filter((I,U)=>U%2===0);for(let I of d)h.forEach((U,k)=>I.move(2*k,k));p*=2}}return{add(N){T(N),R();let v=performance.now();v-m<pC||l.children.length>1||l.contains(document.activeElement)||(m=v,S())}}}var sa={along:"place",xLabel:"place along the route"};function vl(n,e){let t=n.map((i,s)=>s).filter(i=>n[i]!==null);return t.sort((i,s)=>n[i]-n[s]),{x:t.map(i=>n[i]??null),y:t.map(i=>e[i]??null)}}function gC(n,e,t){return n.some((i,s)=>Math.abs((i??NaN)-(e[s]??NaN))>t*Math.abs(i??0))}function _C(n){let e=n.theory_along,t=yt(n.stations,"s_m")??[],i=[],s=(a,l,c,u)=>{let h=u?yt(n.stations,u):null;e&&rn(c)?i.push({label:a,role:l,...vl(e.s_m,c)}):rn(h)&&i.push({label:a,role:l,...vl(t,h)})},r=e?.forward_N,o=e&&rn(e.run_N)?e.run_N:void 0;return s("reference theory","theory",o??r,"reference_N"),o&&rn(r)&&gC(o,r,.005)&&s("theory, the whole route full of cable","third",r,null),s("theory, pulled the other way","backward",e?.backward_N,null),s("piece formulas (eq. 3-10)","paper",e?.paper_N,"paper_N"),i}function bl(n){let e=n.envelope?.place,t=yt(n.stations,"s_m")??[],i=[],s;e&&rn(e.tension_min_N)&&rn(e.tension_max_N)&&(i.push({label:"simulated, least",role:"envelope",x:e.s_m,y:e.tension_min_N,quiet:!0}),i.push({label:"simulated, largest",role:"envelope",x:e.s_m,y:e.tension_max_N,quiet:!0}),s={low:0,high:1,label:"simulated, least to largest of the run"});let r=yt(n.stations,"mean_N");rn(r)?i.push({label:"simulated, steady mean",role:"simulated",...vl(t,r)}):e&&rn(e.tension_mean_N)&&i.push({label:"simulated, mean of the run",role:"simulated",x:e.s_m,y:e.tension_mean_N});let o=yt(n.stations,"peak_N");if(!s&&rn(o)&&i.push({label:"simulated, peak of the run",role:"peak",...vl(t,o)}),i.push(..._C(n)),i.length===0)return null;let a=yr(n,"pull")?.where;return{id:"tension",title:"Tension along the route",caption:"Tension of the cable that passes a place. The theory for the other direction is of the whole route full of cable."+(a?` The largest was at ${a}.`:""),...sa,yLabel:"tension",yUnit:"N",curves:i,levels:Kr(n,"pull"),...s?{band:s}:{}}}var xC=n=>n.map(e=>e===null?null:Math.max(0,-e));function Cx(n){let e=yr(n,"buckling"),t=e?.value?bl(n):null;if(!t)return null;let s=t.curves.filter(r=>["envelope","simulated","theory"].includes(r.role)).filter(r=>r.label!=="simulated, largest").map(r=>({...r,y:xC(r.y),label:r.label.replace("least","largest of the run"),quiet:!1}));return s.some(r=>r.y.some(o=>(o??0)>0))?{id:"push",title:"Push along the route",caption:"What a machine pushes the cable with, where its tension is below 0. Beyond the allowed push it snakes or coils in a duct, or bows between carriers and guides."+(e?.where?` It is nearest to that at ${e.where}.`:""),...sa,yLabel:"push",yUnit:"N",curves:s,levels:Kr(n,"buckling","push")}:null}function yC(n){let e=n.theory_along;return!e||!rn(e.forward_sidewall_N_per_m)?null:{label:"reference theory, T/R",role:"theory",x:e.s_m,y:e.forward_sidewall_N_per_m}}function vC(n){let{theory_along:e,geometry:t}=n,i=e&&rn(e.curvature_per_m)?e:t?.route;if(!i?.curvature_per_m||!rn(i.curvature_per_m))return null;let s=i.curvature_per_m.map(r=>r===null?null:Math.abs(r));return{label:"route",role:"theory",x:i.s_m,y:s}}function Rx(n){let e=n.envelope?.place,t=[];e&&rn(e.sidewall_max_N_per_m)&&t.push({label:"simulated, largest of the run",role:"simulated",x:e.s_m,y:e.sidewall_max_N_per_m});let i=yC(n);return i&&t.push(i),t.length===0?null:{id:"sidewall",title:"Sidewall pressure along the route",caption:"Force per length with which the cable presses sideways.",...sa,yLabel:"sidewall pressure",yUnit:"N/m",curves:t,levels:Kr(n,"sidewall")}}function Px(n){let e=n.envelope?.place;if(!e||!rn(e.curvature_max_per_m))return null;let t=[{label:"cable, largest of the run",role:"simulated",x:e.s_m,y:e.curvature_max_per_m}],i=vC(n);i&&t.push(i);let s=yr(n,"bend_radius")?.limit;return{id:"curvature",title:"Curvature along the route",caption:"One over the radius to which the cable is bent. The allowed curvature is one over the allowed radius.",...sa,yLabel:"curvature",yUnit:"1/m",curves:t,levels:s?[{label:"allowed",value:1/s}]:[]}}function Ix(n){let e=n.geometry;if(!e||e.route.s_m.length<2)return null;let{s_m:t,position_m:i}=e.route,s=i.map(l=>l[2]),r=[{label:"route",role:"route",x:t,y:s}],o=e.rollers.filter(l=>l.s_m!==null);o.length>0&&r.push({label:"rollers",role:"ground",points:!0,x:o.map(l=>l.s_m),y:o.map(l=>l.position_m[2])});let a=e.conveyors;if(a.length>0){let l=[],c=[];for(let{from_m:u,to_m:h}of a)l.push(u,h,h+1e-6),c.push(ys(t,s,u),ys(t,s,h),null);r.push({label:"conveyors",role:"second",x:l,y:c})}return{id:"profile",title:"Profile",caption:"Height over the place along the route; the scales of the two axes differ.",...sa,yLabel:"height",yUnit:"m",fromZero:!1,span:2,curves:r,height:200}}function Lx(n){let e=yt(n.rollers,"s_m");if(!rn(e))return null;let t=[],i=(o,a,l)=>{let c=yt(n.rollers,o);rn(c)&&t.push({label:a,role:l,points:!0,...vl(e,c)})};if(i("steady_N","steady mean","simulated"),i("peak_N","peak of the run","second"),t.length===0)return null;let s=new Set((yt(n.rollers,"rating_N")??[]).filter(o=>o!==null)),r=s.size===1?[...s][0]:null;return{id:"rollers",title:"Loads of the rollers along the route",caption:e.includes(null)?"Rollers that were placed by coordinates have no place along the route; the table below has all.":"Where each roller stands.",...sa,yLabel:"load",yUnit:"N",curves:t,levels:r?[{label:"rating",value:r}]:[]}}function Ml(n){let e=new Map;return n.map(t=>{let i=t.label||t.summary.title||"run",s=(e.get(i)??0)+1;return e.set(i,s),s===1?i:`${i} (${s})`})}function Lh(n,e){let t=Ml(n);return n.flatMap((i,s)=>{let r=e(i);return r&&rn(r.y)?[{label:t[s]??"",role:Gs[s],...r}]:[]})}var bC=n=>{let e=bl(n)?.curves.find(({role:t})=>t==="simulated");return e?{x:e.x,y:e.y}:null},MC=n=>{let e=n.envelope?.place;return e?.sidewall_max_N_per_m?{x:e.s_m,y:e.sidewall_max_N_per_m}:null},SC=n=>{let[e,t]=[yt(n.series,"time_s"),yt(n.series,"winch_force_N")];return e&&t?{x:e,y:t}:null},wC=n=>{let[e,t]=[yt(n.series,"head_at_m"),yt(n.series,"winch_force_N")],i=e?dn(e):null;return e&&t&&i&&i[1]-i[0]>.5?{x:e,y:t}:null};function Nx(n){return[{id:"together-tension",title:"Tension along the route, all runs",caption:"Steady means of the simulation; of a run without them the mean of the run.",along:"place",xLabel:"place along the route",yLabel:"tension",yUnit:"N",curves:Lh(n,bC)},{id:"together-sidewall",title:"Sidewall pressure along the route, all runs",caption:"The largest of each run.",along:"place",xLabel:"place along the route",yLabel:"sidewall pressure",yUnit:"N/m",curves:Lh(n,MC)},{id:"together-force",title:"Force at the winch over time, all runs",caption:"As simulated.",along:"time",xLabel:"time",yLabel:"force",yUnit:"N",curves:Lh(n,SC)},{id:"together-head",title:"Force at the winch over the place of the cable\u2019s head, all runs",caption:"As simulated, of the runs in which the head moves along the route.",along:"place",xLabel:"place of the cable\u2019s head along the route",yLabel:"force",yUnit:"N",curves:Lh(n,wC)}].filter(t=>t.curves.length>1)}function Pt(n,e,...t){let i=A("h2",{id:`${n}-heading`},e);return A("section",{id:n,"aria-labelledby":`${n}-heading`},i,...t)}function mn(n){return A("p",{class:"note"},n)}var TC={safe:"M6 12.5l4 4 8-9",conditional:"M9 9.2c0-4.2 6.4-3.6 6 .2-.3 2.4-3 2.3-3 5M12 17.2v.6",unsafe:"M7 7l10 10M17 7L7 17",untrusted:"M12 6v8M12 17.2v.6",unjudged:"M7 12h10"};function vr(n){let e=Qe("circle",{cx:12,cy:12,r:11,fill:"currentColor"}),t=Qe("path",{d:TC[n],fill:"none",stroke:"var(--surface)","stroke-width":2.6,"stroke-linecap":"round"});return Qe("svg",{viewBox:"0 0 24 24",class:"sign","aria-hidden":"true"},e,t)}function Nh(n,e){let i=Math.max(0,Math.min(1.5,n))*66,s=Qe("rect",{x:0,y:3,width:i,height:8,class:"bar",rx:1}),r=Qe("path",{d:"M66 0V14",class:"bar-limit"}),o=Qe("svg",{viewBox:"0 0 100 14",class:"usage","aria-hidden":"true",preserveAspectRatio:"none"},s,r);return A("span",{class:`usage-box ${e}`},o)}function br(n,e,t,i,s){let r=i.filter(({key:l})=>t.some(c=>c[l]!==void 0&&c[l]!==null&&c[l]!=="")),o=r.map(({key:l,unit:c})=>{let u=t.map(h=>typeof h[l]=="number"?Math.abs(h[l]):0);return c?kt(c,s,Math.max(0,...u)):null}),a={name:`hawser-${n}`,columns:r.map(({label:l},c)=>({label:l,unit:o[c]?.symbol??""})),rows:t.map(l=>r.map(({key:c},u)=>{let h=l[c];return typeof h=="number"?h*(o[u]?.factor??1):h}))};return A("div",{class:"record"},Ld(a,e),$i(()=>a))}function Fn(n,e,t=""){return A("div",{class:"fact"},A("dt",{},n),A("dd",{},e),t?A("dd",{class:"detail"},t):null)}function _p(n,e,t,i){if(n==null||e===null||e===void 0||n===0)return"";let s=Ye(100*e/Math.abs(n),"%",i,2);return`\xB1 ${Ye(e,t,i,2)} (${s})`}var EC=(n,e)=>dn(yt(n.rollers,e)??[])?.[1]??null;function AC(n){let e=(t,i,s)=>({label:t,unit:i,values:n.map(r=>s(r)??null)});return[e("Pull, steady mean","N",t=>t.summary.pull_force?.steady_mean_N),e("Pull, peak","N",t=>t.summary.pull_force?.peak_N),e("Pull by the reference theory","N",t=>t.summary.theory?.reference_total_N),e("Largest roller load","N",t=>EC(t,"peak_N")),e("Speed, steady mean","m/s",t=>t.summary.speed?.steady_m_per_s),e("Settled after","s",t=>t.summary.speed?.settle_time_s)]}function Fx(n){let e=new Map;for(let t of n)for(let i of t.summary.limits??[])e.has(i.name)||e.set(i.name,{label:Vn(i.name),unit:Zr(i),values:[]});for(let[t,i]of e)i.values=n.map(s=>s.summary.limits?.find(r=>r.name===t)?.value??null);return[...e.values()]}function CC(n){return Fx(n).map(e=>{let t=i=>i.summary.limits?.find(s=>Vn(s.name)===e.label)?.margin??null;return{label:e.label,unit:"%",values:n.map(i=>{let s=t(i);return s===null?null:100*s})}})}function RC(n){let e=n.map(i=>{let s=yt(i.stations,"mean_N")??[];return new Map(xr(i.stations,"name").map((r,o)=>[r,s[o]??null]))});return[...new Set(e.flatMap(i=>[...i.keys()]))].map(i=>({label:i,unit:"N",values:e.map(s=>s.get(i)??null)}))}function PC(n){let e=[{label:"Key figures",rows:AC(n)},{label:"Limits: what was found",rows:Fx(n)},{label:"Limits: margin",rows:CC(n)},{label:"Stations: mean tension",rows:RC(n)}],t=i=>i.values.some(s=>s!==null);return e.map(({label:i,rows:s})=>({label:i,rows:s.filter(t)})).filter(({rows:i})=>i.length>0)}function IC(n,e){let t=n.values[0]??null;if(t===null||e===null)return"";let i=n.unit==="%"?e-t:100*(e-t)/Math.abs(t);if(!Number.isFinite(i))return"";let s=fn(i,2);return`${i>0?"+":""}${s}\u202F${n.unit==="%"?"points":"%"}`}function LC(n,e){let t=Math.max(...n.values.map(r=>Math.abs(r??0))),i=n.unit==="%"?{symbol:"%",factor:1}:kt(n.unit,e.units,t),s=n.values.map((r,o)=>{let a=r===null?ci:fn(r*i.factor),l=o===0?"":IC(n,r);return A("td",{class:r===null?"unknown":"number"},a,l?A("span",{class:"difference"},l):null)});return A("tr",{},A("th",{scope:"row"},ft(n.label),i.symbol?`, ${i.symbol}`:""),...s)}function NC(n,e){return{name:"hawser-comparison",columns:["group","figure","unit",...e].map(t=>({label:t})),rows:n.flatMap(t=>t.rows.map(i=>[t.label,i.label,i.unit,...i.values]))}}var Dx=24;function Ux(n){let{runs:e}=n.data;if(e.length<2)return null;let t=Ml(e),i=PC(e),s=e.map(d=>{let f=xl(d),p={safe:"safe",conditional:"safe only if",unsafe:"not safe",untrusted:"not trusted",unjudged:"not judged"};return A("td",{},A("span",{class:`standing-word ${f}`},vr(f),p[f]))}),r=t.map((d,f)=>{let p=n.store.get("run")===f,_=A("button",{type:"button",class:"pick","aria-pressed":String(p),onclick:()=>n.store.set("run",f)},ft(d));return A("th",{scope:"col"},_)}),o=i.map(d=>{let f=A("tr",{class:"group"},A("th",{colspan:t.length+1,scope:"rowgroup"},d.label));return A("tbody",{},f,...d.rows.slice(0,Dx).map(p=>LC(p,n)))}),l=`Differences are from the first run. Choose a run to see all of it below, and in three dimensions.${i.some(d=>d.rows.length>Dx)?" Long lists are cut; the CSV has all of them.":""}`,c=A("table",{class:"compare"},A("caption",{},l),A("thead",{},A("tr",{},A("td"),...r)),A("tbody",{},A("tr",{},A("th",{scope:"row"},"Verdict"),...s)),...o),u=A("div",{class:"scroll",tabindex:0,role:"region","aria-label":"Comparison of the runs"},c),h=Nx(e).map(d=>n.figure(d));return Pt("compare","Comparison",u,$i(()=>NC(i,t)),...h)}function ra(n,e,t,i,s,r,o){let a=yt(n.series,"time_s");if(!rn(a))return null;let l=o.flatMap(({name:d,label:f,role:p})=>{let _=yt(n.series,d);return rn(_)?[{label:f,role:p,x:a,y:_}]:[]});if(l.length===0)return null;let c=ix(n),u=nx(n),h=u.length>0?" Numbers: see Events.":"";return{id:e,title:t,caption:i+h,along:"time",xLabel:"time",yLabel:s,yUnit:r,curves:l,events:u,...c?{window:c}:{}}}function Ox(n){let e=ra(n,"force","Force at the winch over time","Forces of the run, and what the theory expects.","force","N",[{name:"winch_force_N",label:"winch",role:"simulated"},{name:"max_tension_N",label:"largest tension anywhere",role:"second"},{name:"tail_tension_N",label:"tail",role:"third"},{name:"reference_N",label:"winch by the reference theory",role:"theory"}]);return e&&{...e,levels:Kr(n,"pull")}}function xp(n){let e=yt(n.series,"head_at_m"),t=yt(n.series,"time_s"),i=rn(e)?dn(e):null;if(!i||i[1]-i[0]<.5||!e||!t)return null;let s=e.map((u,h)=>h).filter(u=>e[u]!==null);s.sort((u,h)=>e[u]-e[h]);let r=u=>s.map(h=>u[h]??null),o=r(e),a=[],l=(u,h,d)=>{let f=yt(n.series,u);rn(f)&&a.push({label:h,role:d,x:o,y:r(f)})};l("winch_force_N","simulated","simulated"),l("reference_N","reference theory","theory");let c=n.summary.pull_by_position??[];if(c.length>0){let u=h=>c.map(d=>d[h]??null);a.push({label:"simulated, means of stretches",role:"second",points:!0,x:u("head_m"),y:u("pull_N")})}return a.length===0?null:{id:"head",title:"Force at the winch over the place of the cable\u2019s head",caption:"How the pull grows while the cable comes in: what the crew sees at the winch when the head is at a place.",along:"head",xLabel:"place of the cable\u2019s head along the route",yLabel:"force",yUnit:"N",curves:a,levels:Kr(n,"pull"),clock:{time:t,head:e}}}function kx(n){let e=Object.keys(n.series??{}).filter(s=>/^speed_\d+_m_per_s$/.test(s)),t=e.slice(0,Gs.length),i=e.length>t.length?` The first ${t.length} of ${e.length} watched segments.`:"";return ra(n,"speed","Speeds over time",`Segments are numbered from the tail, 0.${i}`,"speed","m/s",[{name:"winch_speed_m_per_s",label:"winch",role:"theory"},...t.map((s,r)=>({name:s,label:`segment ${s.split("_")[1]}`,role:Gs[r]}))])}var Vx={"vector-effect":"non-scaling-stroke"};function zx(n){let e=t=>{let i=n.route.position_m.map(s=>s[t]);return Math.max(...i)-Math.min(...i)};return e(1)>1.2*e(0)?t=>[t[1],t[0]]:t=>[t[0],-t[1]]}function Bx(n,e,t){let i=n.map(s=>e(s).map(r=>r.toFixed(3)).join(" ")).join("L");return Qe("path",{d:`M${i}`,fill:"none",class:t,...Vx})}function Dh([n,e]){return`M${n} ${e}h0.001`}function yp(n,e,t){return Qe("path",{d:Dh(n),class:e,...Vx},Qe("title",{},t))}function Gx(n,e){let t=(s,r)=>s.filter(({points_m:o})=>o.length>1).map(({points_m:o})=>Bx(o,e,r)),i=[...t(n.surfaces,"plan-surface"),Bx(n.route.position_m,e,"plan-route"),...t(n.conveyors,"plan-conveyor"),...n.rollers.map(s=>yp(e(s.position_m),"plan-roller",s.name))];return n.reel&&i.push(yp(e(n.reel.center_m),"plan-reel","reel")),n.winch&&i.push(yp(e(n.winch.position_m),"plan-winch","winch")),i}function Hx(n){let t=[{name:"route",label:"route",there:!0,long:!0},{name:"roller",label:"rollers",there:n.rollers.length>0,long:!1},{name:"conveyor",label:"conveyors",there:n.conveyors.length>0,long:!0},{name:"surface",label:"ducts, trays, walls",there:n.surfaces.length>0,long:!0},{name:"reel",label:"reel",there:n.reel!==null,long:!1},{name:"winch",label:"winch",there:n.winch!==null,long:!1}].filter(({there:i})=>i).map(({name:i,label:s,long:r})=>{let o=Qe("path",{d:r?"M2 6H24":Dh([13,6]),class:`plan-${i}`}),a=Qe("svg",{width:26,height:12,class:"swatch","aria-hidden":"true"},o);return A("li",{},A("span",{class:"legend-item"},a,s))});return A("ul",{class:"legend"},...t)}function Wx(n,e,t,i){let s=null,r=1/0;return n.route.position_m.forEach((o,a)=>{let[l,c]=e(o),u=(l-t)**2+(c-i)**2;u<r&&([r,s]=[u,n.route.s_m[a]??null])}),s}function Xx(n,e){let{symbol:t,factor:i}=kt("m",e,1),s=(d,f,p,_)=>[d,f,p===null?null:p*i,...[0,1,2].map(g=>_?.[g]===void 0?null:_[g]*i)],{route:r,rollers:o,conveyors:a,surfaces:l,reel:c,winch:u}=n,h=(d,f,p,_,g)=>[s(`${d}, beginning`,f,_,p[0]),s(`${d}, end`,f,g,p.at(-1))];return{name:"hawser-plan",columns:[{label:"what"},{label:"name"},{label:"place along the route",unit:t},...["x","y","z"].map(d=>({label:d,unit:t}))],rows:[...c?[s("reel","",null,c.center_m)]:[],...u?[s("winch","",null,u.position_m)]:[],...a.flatMap(d=>h("conveyor",d.name,d.points_m,d.from_m,d.to_m)),...l.flatMap(d=>h(d.kind,d.name,d.points_m,d.from_m??null,d.to_m??null)),...o.map(d=>s(d.kind,d.name,d.s_m,d.position_m)),...r.s_m.map((d,f)=>s("route","",d,r.position_m[f]))]}}function Uh(n){let e=n.map(r=>r[0]),t=n.map(r=>r[1]),[i,s]=[Math.min(...e),Math.min(...t)];return{x:i,y:s,width:Math.max(...e)-i,height:Math.max(...t)-s}}function vp(n,e){let t=Math.max(n.width,n.height*e),i=t/e;return{x:n.x+(n.width-t)/2,y:n.y+(n.height-i)/2,width:t,height:i}}function Sl(n,e){let[t,i]=[n.width*e,n.height*e];return{x:n.x+(n.width-t)/2,y:n.y+(n.height-i)/2,width:t,height:i}}var Fh=(n,e,t)=>({...n,x:n.x+e*n.width,y:n.y+t*n.height});function DC(n,e,t){switch(n){case"+":case"=":return Sl(e,.5);case"-":return e.width*2>t.width?t:Sl(e,2);case"0":return t;case"ArrowLeft":return Fh(e,-.1,0);case"ArrowRight":return Fh(e,.1,0);case"ArrowUp":return Fh(e,0,-.1);case"ArrowDown":return Fh(e,0,.1);default:return null}}var Oh=class{constructor(e,t,i,s,r){this.drawing=e;this.all=i;this.onView=s;this.onPoint=r;this.view=i,e.append(this.band),e.addEventListener("mousedown",o=>{this.start=this.at(o),o.preventDefault()}),e.addEventListener("mousemove",o=>this.move(this.at(o))),e.addEventListener("mouseup",o=>this.end(this.at(o))),e.addEventListener("mouseleave",()=>{this.end(null),r(null)}),e.addEventListener("dblclick",()=>this.show(i)),t.addEventListener("keydown",o=>{let a=o.ctrlKey||o.metaKey||o.altKey?null:DC(o.key,this.view,i);a&&(o.preventDefault(),this.show(a))}),this.show(i)}drawing;all;onView;onPoint;view;start=null;band=Qe("rect",{class:"plan-band","vector-effect":"non-scaling-stroke",width:0,height:0});show(e){this.view=e,this.drawing.setAttribute("viewBox",`${e.x} ${e.y} ${e.width} ${e.height}`),this.onView(e)}zoomIn(){this.show(Sl(this.view,.5))}showAll(){this.show(this.all)}at(e){let t=this.drawing.getScreenCTM();if(!t)return[0,0];let{x:i,y:s}=new DOMPoint(e.clientX,e.clientY).matrixTransform(t.inverse());return[i,s]}move(e){if(this.start)for(let[t,i]of Object.entries(Uh([this.start,e])))this.band.setAttribute(t,String(i));this.onPoint(e)}end(e){let t=this.start&&e?Uh([this.start,e]):null;this.start=null,this.band.setAttribute("width","0"),t&&Math.max(t.width,t.height)>this.view.width*.02&&this.show(vp(t,this.all.width/this.all.height))}};var qx=900,FC="Arrow keys move it, plus and minus zoom, 0 shows all.";function $x(n){let{run:e,store:t,units:i}=n,s=e.geometry;if(!s||s.route.position_m.length<2)return null;let r=zx(s),o=[s.reel?.center_m,s.winch?.position_m].filter(v=>v!==void 0),a=s.rollers.map(v=>v.position_m),l=Uh([...s.route.position_m,...a,...o].map(r)),c=Math.min(6,Math.max(1.8,l.width/Math.max(l.height,1e-9))),u=Sl(vp({...l,width:Math.max(l.width,.001)},c),1.1),h=Qe("path",{class:"plan-pointer","vector-effect":"non-scaling-stroke",d:""}),d=`Plan of the route, ${Ye(s.route.s_m.at(-1),"m",i)} long`,f=Qe("svg",{class:"plan",width:qx,height:qx/c,role:"img","aria-label":d},...Gx(s,r),h),p=A("div",{class:"frame",tabindex:0,role:"group","aria-label":`${d}. ${FC}`},f),_=A("p",{class:"plan-scale"}),g=kt("m",i,1),m={},S=new Oh(f,p,u,v=>_.textContent=`Width of the drawing: ${fn(v.width*g.factor,3)} ${g.symbol}.`,v=>{let E=v&&Wx(s,r,v[0],v[1]);t.set("place",E,m),C(E)}),C=v=>{let{s_m:E,position_m:F}=s.route,[I,U,k]=[0,1,2].map(O=>v===null?null:ys(E,F.map($=>$[O]),v)),X=typeof I=="number"&&typeof U=="number"&&typeof k=="number";h.setAttribute("d",X?Dh(r([I,U,k])):"")};n.onDispose(t.subscribe("place",(v,E)=>E!==m&&C(v))),C(t.get("place"));let b=A("div",{class:"tools"},ni("Zoom in",()=>S.zoomIn()),ni("Show all",()=>S.showAll())),[R,T]=Jl(()=>Xx(s,i),"What stands where",!1,()=>{});R&&b.append(...R.childNodes);let N=T?[T]:[];return A("figure",{id:"figure-plan",class:"figure"},A("h3",{},"Plan"),Hx(s),p,A("figcaption",{},A("p",{class:"caption"},"The route from above, both directions to the same scale."),_,b,...N))}var kh="These results are of an older hawser, or of a run that was cut short: compute them again to have it.",Yx=n=>{let{run:e}=n,t=[],i=bl(e);t.push(i?n.figure(i):mn(`There is no tension along the route in these results. ${kh}`));let s=Cx(e);s&&t.push(n.figure(s));let r=Rx(e);t.push(r?n.figure(r):mn(`There is no sidewall pressure along the route in these results. ${kh}`));let o=Px(e);return o&&t.push(n.figure(o)),Pt("along","Along the route",...t)},Zx=n=>{let e=Ix(n.run),t=$x(n);return!e||!t?Pt("route","Plan and profile",mn(`There is no geometry of the route in these results. ${kh}`)):Pt("route","Plan and profile",t,n.figure(e))},Kx=n=>{let{run:e}=n,t=[Ox(e),xp(e),kx(e)].filter(s=>s!==null);if(t.length===0)return Pt("time","Over time",mn(`There is nothing over time in these results. ${kh}`));let i=xp(e)?null:mn("The cable\u2019s head does not move along the route in this run, so there is no force over its place.");return Pt("time","Over time",...t.map(s=>n.figure(s)),i)};function UC(n,e){if(n==null||!e)return"";let t=100*(n-e)/e;return`simulated ${fn(Math.abs(t),2)}\u202F% ${t<0?"below":"above"}`}function OC(n){let{run:e,units:t}=n,i=yt(e.rollers,"peak_N"),s=i?dn(i)?.[1]:void 0;if(!i||s===void 0)return null;let r=i.indexOf(s),o=yt(e.rollers,"rating_N")?.[r]??null,a=xr(e.rollers,"name")[r]??"",l=o===null?"no rating given":`rated ${Ye(o,"N",t)}`;return Fn("Largest roller load",Ye(s,"N",t),A("span",{},ft(a),`, ${l}`))}function Jx(n,e){let t=yr(n.run,e);if(!t||t.value===null)return null;let i=e==="sidewall"?"N/m":"m",s=t.where?ft(Bn(t.where,n.units)):"";return Fn(Vn(e),Ye(t.value,i,n.units),s)}function kC(n){let e=n.run.summary.passes;if(!e)return null;let t=(e.pass?.length??0)>2,i={replaced:`All figures of this page are those of a ${t?"third":"second"} pass with finer settings; those of the first stand under`,compared:`All figures of this page are those of the first of ${t?"three":"two"} passes, and their \xB1 is from all; the others\u2019 stand under`,declined:"A second pass with finer settings would narrow \xB1; what it would take stands under"},s=A("a",{href:"#trust"},"trust");return A("p",{class:"note"},i[e.outcome]??"A second pass was begun and did not end; why stands under"," ",s,".")}function jx(n){let{run:e,units:t}=n,{pull_force:i,theory:s,speed:r}=e.summary,o=s?.reference_total_N,a=dn(yt(e.series,"max_tension_N")??[])?.[1]??yr(e,"pull")?.value,l=r?.settle_time_s,c=[Fn("Pull, steady mean",Ye(i?.steady_mean_N,"N",t),_p(i?.steady_mean_N,i?.steady_mean_error?.total_N,"N",t)),Fn("Pull, peak of the run",Ye(i?.peak_N,"N",t),_p(i?.peak_N,i?.peak_error?.total_N,"N",t)),Fn("Pull by the reference theory",Ye(o,"N",t),UC(i?.steady_mean_N,o)),Fn("Largest tension anywhere",Ye(a,"N",t),"rope included"),Jx(n,"sidewall"),Jx(n,"bend_radius"),OC(n),Fn("Speed, steady mean",Ye(r?.steady_m_per_s,"m/s",t),l==null?"":`settled after ${Ye(l,"s",t)}`)],h=i?.steady_mean_error||i?.peak_error?mn("\xB1 is what a figure may be off by through the numbers alone: steps in time, length of segments, friction at rest."):null;return Pt("key-figures","Key figures",A("dl",{class:"facts"},...c),h,kC(n))}function Qx(n){return n.ok===null?"unjudged":n.ok?"safe":"unsafe"}var ey={safe:"holds",conditional:"",unsafe:"broken",unjudged:"not judged",untrusted:""};function BC(n,e){let{units:t,store:i}=e,s=Zr(n),r=Qx(n),o=n.margin===null?ci:`${fn(100*n.margin,3)}\u202F%`,a=/^(-?\d+(?:\.\d+)?) m\b/.exec(n.where),l=a?Number(a[1]):null,c=h=>()=>{l!==null&&i.set("place",h?l:null)},u=h=>A("td",{class:h===ci?"unknown":"number"},h);return A("tr",{class:r,onmouseenter:c(!0),onmouseleave:c(!1)},A("th",{scope:"row"},Vn(n.name)),A("td",{class:"standing"},A("span",{class:`standing-word ${r}`},vr(r),ey[r])),u(Ye(n.value,s,t)),u(Ye(n.limit,s,t)),u(o),A("td",{class:"usage-cell"},n.margin===null?null:Nh(1-n.margin,r)),A("td",{},ft(Bn(n.where,t))),A("td",{class:"source"},ft(Bn(n.source,t))))}var VC=["Limit","","Found","Allowed","Margin","Used","Where","Source, or why it was not judged"];function ty(n){let{run:e,units:t}=n,i=e.summary.limits;if(!i)return Pt("limits","Limits",mn("These results hold no limits: they are of an older hawser."));if(i.length===0)return Pt("limits","Limits",mn("The case has no section \u201Climits\u201D, so nothing was judged."));let s=[..._l(e),...i.filter(c=>c.ok===null||c.margin===null)],r=VC.map(c=>A("th",{scope:"col","aria-label":c||"Standing"},c)),o=A("table",{class:"limits"},A("caption",{},"The smallest margin first. The line in a bar is all that is allowed."),A("thead",{},A("tr",{},...r)),A("tbody",{},...s.map(c=>BC(c,n)))),a=()=>({name:"hawser-limits",columns:["limit","standing","found","allowed","unit","margin","where","source"].map(c=>({label:c})),rows:s.map(c=>{let{symbol:u,factor:h}=kt(Zr(c),t,c.limit??c.value??0),d=f=>f===null?null:f*h;return[c.name,ey[Qx(c)],d(c.value),d(c.limit),u,c.margin,c.where,c.source]})}),l=A("div",{class:"scroll",tabindex:0,role:"region","aria-label":"Table of limits"},o);return Pt("limits","Limits",l,$i(a))}function zC(n,e,t){let i=[...n].sort((o,a)=>Math.abs(Number(a[t]??0))-Math.abs(Number(o[t]??0))),s=new Set(i.slice(0,Gs.length)),r=n.filter(o=>s.has(o)).map((o,a)=>({name:`${String(o.name)}_${e}`,label:String(o.name),role:Gs[a]}));return{columns:r,left:n.length-r.length}}function Bh(n,e,t){let{columns:i,left:s}=zC(e,t.suffix,t.size),r=s>0?` The ${i.length} largest; ${s} more are in the table of machines.`:"";return ra(n,t.id,t.title,t.caption+r,t.label,t.unit,i)}var bp=n=>n.filter(e=>e!==null);function ny(n){let e=n.summary.conveyors??[];return bp([Bh(n,e,{id:"conveyor-force",title:"Forces of the conveyors",caption:"Force on the cable along the pull.",suffix:"force_N",size:"peak_N",label:"force",unit:"N"}),Bh(n,e,{id:"conveyor-slip",title:"Slip of the conveyors",caption:"Speed of the cable less that of the belt; 0 where there is no cable.",suffix:"slip_m_per_s",size:"peak_N",label:"slip",unit:"m/s"})])}function iy(n){let e=n.summary.motors??[];return bp([Bh(n,e,{id:"motor-torque",title:"Torques of the driven rollers",caption:"Torque on the roller, positive with the pull.",suffix:"torque_N_m",size:"peak_N_m",label:"torque",unit:"N m"}),Bh(n,e,{id:"motor-speed",title:"Speeds of the driven rollers",caption:"Speed of the roller\u2019s surface.",suffix:"speed_m_per_s",size:"peak_N_m",label:"speed",unit:"m/s"})])}function sy(n){return bp([ra(n,"reel-speed","Speed of the reel","Angular speed of the drum.","speed","rad/s",[{name:"reel_speed_rad_per_s",label:"reel",role:"simulated"}]),ra(n,"reel-cable","Cable on the reel","What has left the drum, and what is still on it.","length","m",[{name:"paid_out_m",label:"paid out",role:"simulated"},{name:"wound_m",label:"wound",role:"second"}])])}var GC=[{key:"name",label:"conveyor"},{key:"from_m",label:"from",unit:"m"},{key:"to_m",label:"to",unit:"m"},{key:"grip_N",label:"largest force",unit:"N"},{key:"reference_N",label:"theory reckons with",unit:"N"},{key:"steady_mean_N",label:"steady mean",unit:"N"},{key:"peak_N",label:"peak",unit:"N"},{key:"belt_m_per_s",label:"belt",unit:"m/s"},{key:"slip_m_per_s",label:"slip",unit:"m/s"},{key:"slipping",label:"share of time slipping",unit:"1"}],HC=[{key:"name",label:"driven roller"},{key:"at_m",label:"place",unit:"m"},{key:"limit_N_m",label:"set or largest torque",unit:"N m"},{key:"reference_N",label:"theory reckons with",unit:"N"},{key:"steady_mean_N_m",label:"steady mean",unit:"N m"},{key:"peak_N_m",label:"peak",unit:"N m"},{key:"surface_m_per_s",label:"surface",unit:"m/s"},{key:"power_W",label:"power",unit:"W"},{key:"at_limit",label:"share of time at its limit",unit:"1"}],WC=[{key:"name",label:"surface"},{key:"kind",label:"kind"},{key:"from_m",label:"from",unit:"m"},{key:"to_m",label:"to",unit:"m"},{key:"clearance_m",label:"clearance",unit:"mm"},{key:"jam_ratio",label:"jam ratio",unit:"1"},{key:"steady_normal_N",label:"normal force, steady mean",unit:"N"},{key:"steady_friction_N",label:"friction, steady mean",unit:"N"},{key:"peak_line_load_N_per_m",label:"largest force per length",unit:"N/m"},{key:"peak_line_load_error",label:"off by at most",unit:"N/m"},{key:"peak_at_m",label:"at",unit:"m"}];function Mp(n,e){return e.map(t=>n.figure(t))}var ry=n=>{let e=n.run.summary.conveyors??[];if(e.length===0)return null;let t=br("conveyors","Conveyors",e,GC,n.units);return Pt("conveyors","Conveyors",t,...Mp(n,ny(n.run)))},oy=n=>{let e=n.run.summary.motors??[];if(e.length===0)return null;let t=br("motors","Driven rollers",e,HC,n.units);return Pt("motors","Driven rollers",t,...Mp(n,iy(n.run)))},ay=n=>{let e=sy(n.run);return e.length>0?Pt("reel","Reel",...Mp(n,e)):null},ly=n=>{let e=n.run.summary.surfaces??[];return e.length===0?null:Pt("surfaces","Ducts, trays and walls",br("surfaces","Surfaces",e,WC,n.units))};function uy(n,e){return A("div",{class:"scroll",tabindex:0,role:"region","aria-label":n},e)}function hy(...n){return A("thead",{},A("tr",{},...n.map(e=>A("th",{scope:"col"},e))))}var XC=[{key:"which",label:"pass"},{key:"segments",label:"segments",unit:"1"},{key:"accuracy",label:"accuracy",unit:"1"},{key:"v_s_factor",label:"speed at which friction comes in, of the case\u2019s",unit:"1"},{key:"steady_mean_N",label:"pull, steady mean",unit:"N"},{key:"steady_mean_bar_N",label:"\xB1 by itself",unit:"N"},{key:"peak_N",label:"pull, peak",unit:"N"},{key:"peak_bar_N",label:"\xB1 by itself",unit:"N"},{key:"steps",label:"steps",unit:"1"},{key:"wall_time_s",label:"computed in",unit:"s"}];function qC(n,e){let t=n.pass??[],i=n.outcome==="replaced"?t.length-1:0,s=t.map((o,a)=>({which:`${["first","second","third"][a]??a+1}${a===i?", shown":""}`,...o})),r=`${n.why}: ${n.says}.`;return[A("h3",{},"Passes"),A("p",{},ft(Bn(r.charAt(0).toUpperCase()+r.slice(1),e))),br("passes","What each pass found before it knew of the others.",s,XC,e)]}var dy=({run:n,units:e})=>{let t=n.summary.trust;if(!t)return Pt("trust","Can these figures be trusted?",mn("These results hold no conditions of trust: they are of an older hawser."));let i=t.filter(c=>c.holds===!1).length,s=i===0?`Yes: all ${t.length} conditions hold.`:`No: ${i} of ${t.length} conditions ${i===1?"does":"do"} not hold.`,r=(c,u)=>c===null?ci:Ll(u)?Ye(c,u,e,3):`${fn(c,3)} ${u}`,o=c=>{let u=c.holds===!1?"unsafe":c.holds?"safe":"unjudged",h=c.holds===!1?"fails":c.holds?"holds":"not judged";return A("tr",{class:u},A("th",{scope:"row"},Vn(c.name)),A("td",{class:"standing"},A("span",{class:`standing-word ${u}`},vr(u),h)),A("td",{class:"number"},r(c.value,c.unit)),A("td",{class:"number"},r(c.allowed,c.unit)),A("td",{class:"source"},c.holds===!1?ft(Bn(c.remedy,e)):null))},a=[...t].sort((c,u)=>+(c.holds!==!1)-+(u.holds!==!1)),l=A("table",{},A("caption",{},"Conditions under which the run is worth judging."),hy("Condition","Standing","Found","Allowed","What to do"),A("tbody",{},...a.map(o)));return Pt("trust","Can these figures be trusted?",A("p",{},s),uy("Conditions of trust",l),...n.summary.passes?qC(n.summary.passes,e):[])},cy={given:"given in the case",catalogue:"from the catalogue",estimated:"estimated",default:"default"};function $C(n,e=[]){let t=new Map(e.map(({key:i,source:s})=>[i,s]));return n?n.map(({key:i,value:s,origin:r,where:o})=>[i,s,r,o||t.get(i)||""]):e.map(({key:i,value:s,origin:r,source:o})=>[i,s,r,o])}var fy=({run:n})=>{let e=$C(n.inputs,n.summary.assumptions),t="Inputs and assumptions";if(e.length===0)return Pt("inputs",t,mn("These results hold no list of inputs. The case file has them."));let i=new Map;for(let u of e)i.set(u[2]??"",(i.get(u[2]??"")??0)+1);let s=[...i].map(([u,h])=>`${h} ${cy[u]??u}`).join(", "),r=([u="",h="",d="",f=""])=>A("tr",{class:`origin-${/^\w+$/.test(d)?d:"other"}`},A("th",{scope:"row",class:"key"},ft(u)),A("td",{},ft(h)),A("td",{},A("span",{class:"origin"},cy[d]??ft(d))),A("td",{class:"source"},ft(f))),o=A("table",{class:"inputs"},A("caption",{},"As they were read, with their units as in the case."),hy("Input","Value","Origin","Where from"),A("tbody",{},...e.map(r))),a=()=>({name:"hawser-inputs",columns:["input","value","origin","where from"].map(u=>({label:u})),rows:e}),l=e.filter(u=>u[2]==="estimated"||u[2]==="catalogue"),c=l.length>0?`Not from the case itself: ${l.length}. Check these first.`:"";return Pt("inputs",t,A("p",{},`${e.length} values: ${s}. ${c}`),A("details",{class:"long",open:e.length<=40},A("summary",{},"All values"),uy("Inputs",o)),$i(a))},py=({run:n,data:e,units:t})=>{let{summary:i}=n,s=a=>a?ft(a):A("span",{},ci),r=(a,l)=>Ye(i[a],l,t),o=[Fn("Case",s(i.case)),Fn("Results",s(n.label)),Fn("Simulated with",s(i.version&&`hawser ${i.version}`)),Fn("Report by",s(e.hawser&&`hawser ${e.hawser}`),e.generated?ft(e.generated):""),Fn("Simulated time",r("sim_time_s","s")),Fn("Segments",r("segments","1")),Fn("Steps",r("steps","1")),Fn("Computed in",r("wall_time_s","s")),Fn("Outcome",s(i.outcome),i.message?ft(i.message):"")];return Pt("about","Versions",A("dl",{class:"facts small"},...o))},my=({run:n,units:e,store:t})=>{let i=n.summary.events??[];if(i.length===0)return null;let s=o=>()=>t.set("time",o),r=i.map(o=>A("li",{},A("button",{type:"button",class:"pick",onclick:s(o.time_s)},Ye(o.time_s,"s",e))," ",ft(Bn(o.what,e)),o.pull_N===null?"":`, pull ${Ye(o.pull_N,"N",e)}`));return Pt("events","Events",A("ol",{class:"events"},...r))};var YC={key:"name",label:"piece"},ZC=[{key:"from_m",label:"from",unit:"m"},{key:"to_m",label:"to",unit:"m"},{key:"angle_deg",label:"angle, \xB0"},{key:"radius_m",label:"R",unit:"m"},{key:"turns",label:"turns"},{key:"slope_deg",label:"slope, \xB0"},{key:"mu",label:"friction",unit:"1"},{key:"mu_rest",label:"at rest",unit:"1"}],gy=n=>[{key:`${n}_start_N`,label:"in",unit:"N"},{key:`${n}_end_N`,label:"out",unit:"N"},{key:`${n}_rest_N`,label:"from rest",unit:"N"},{key:`${n}_sidewall_N_per_m`,label:"T/R",unit:"N/m"}];function _y(n){let e=n.run.summary.pieces??[];if(e.length===0)return null;let t=e.map(s=>Object.fromEntries(Object.entries(s).map(([r,o])=>[r,o??""]))),i=(s,r,o)=>br(s,r,t,[YC,...o],n.units);return Pt("pieces","The route piece by piece",mn("By theory, full of cable. \u201Cin\u201D and \u201Cout\u201D are tensions in motion; friction has the weight correction of ducts."),i("pieces","Pulled forward",[...ZC,...gy("forward")]),i("pieces-back","Pulled back",[{key:"to_m",label:"from",unit:"m"},{key:"from_m",label:"to",unit:"m"},...gy("back")]))}var Sp=12;function KC(n){let e=n.run.rollers,t=c=>yt(e,c)??[],[i,s,r,o]=[t("s_m"),t("steady_N"),t("peak_N"),t("rating_N")],a=xr(e,"name").map((c,u)=>{let[h,d]=[r[u]??null,o[u]??null],f=h===null||d===null||d<=0?null:h/d;return{index:u,name:c,place:i[u]??null,steady:s[u]??null,peak:h,rating:d,share:f}}),l=c=>c.share??-1;return a.sort((c,u)=>l(u)-l(c)||(u.peak??0)-(c.peak??0))}function xy(n,e,t){let{units:i,store:s}=e,r=n.share===null?"unjudged":n.share>1?"unsafe":"safe",o=n.share===null?ci:Ye(100*(1-n.share),"%",i,3),a=c=>A("td",{class:c===ci?"unknown":"number"},c),l=A("button",{type:"button",class:"pick",onclick:()=>s.set("roller",n.index),title:"Show in the 3-D view"},ft(n.name));return A("tr",{onmouseenter:()=>s.set("place",n.place),onmouseleave:()=>s.set("place",null)},A("th",{scope:"row"},l),a(n.place===null?"by coordinates":Ye(n.place,"m",i)),a(Ye(n.steady,"N",i)),a(Ye(n.peak,"N",i)),...t?[a(n.rating===null?"not given":Ye(n.rating,"N",i)),a(o),A("td",{class:"usage-cell"},n.share===null?null:Nh(n.share,r))]:[])}function yy(n){let e=KC(n);if(!n.run.rollers)return Pt("rollers","Rollers",mn("These results hold no loads of rollers."));if(e.length===0)return null;let t=e.some(p=>p.rating!==null),i=t?"The smallest margin of the peak load against the rating first.":"No roller has a rating in this case, so there are no margins. The largest load first.",s=A("tbody",{},...e.slice(0,Sp).map(p=>xy(p,n,t))),r=e.length>Sp?ni(`Show all ${e.length} rollers`,()=>{s.append(...e.slice(Sp).map(p=>xy(p,n,t))),r?.remove()}):null,o=["Roller","Place","Steady mean","Peak",...t?["Rating","Margin of the peak","Used"]:[]],a=A("table",{class:"rollers"},A("caption",{},i),A("thead",{},A("tr",{},...o.map(p=>A("th",{scope:"col"},p)))),s),l=Lx(n.run),c=kt("N",n.units,1e3),u=kt("m",n.units,1),h=(p,_)=>p===null?null:p*_,d=()=>({name:"hawser-roller-margins",columns:[{label:"roller"},{label:"place",unit:u.symbol},...["steady mean","peak","rating"].map(p=>({label:p,unit:c.symbol})),{label:"margin"}],rows:e.map(p=>[p.name,h(p.place,u.factor),h(p.steady,c.factor),h(p.peak,c.factor),h(p.rating,c.factor),p.share===null?null:1-p.share])}),f=A("div",{class:"scroll",tabindex:0,role:"region","aria-label":"Rollers by margin"},a);return Pt("rollers","Rollers",l?n.figure(l):null,f,r,$i(d))}var JC={safe:"SAFE",conditional:"SAFE ONLY IF",unsafe:"NOT SAFE",untrusted:"NOT TRUSTED",unjudged:"NOT JUDGED"},jC=new Set(["bend_radius","rope_bend","clearance","clearance_environment"]);function QC(n,e){let{units:t}=e,i=Zr(n),s=n.margin??0,r=s<0?`${Ye(-100*s,"%",t,3)} over`:`${Ye(100*s,"%",t,3)} left`,o=jC.has(n.name)?"at least ":"";return A("p",{},A("strong",{},Vn(n.name)),": ",A("strong",{},Ye(n.value,i,t)),n.where?" at ":"",n.where?ft(Bn(n.where,t)):null,`. Allowed: ${o}${Ye(n.limit,i,t)}; `,A("strong",{},r),".")}function eR(n){let{run:e,units:t}=n,i=e.envelope?.place,s=i?.tension_max_N?{s:i.s_m,tension:i.tension_max_N,names:[]}:{s:yt(e.stations,"s_m")??[],tension:yt(e.stations,"peak_N")??[],names:xr(e.stations,"name")},r=dn(s.tension)?.[1];if(r===void 0)return A("p",{},"Where the tension is largest is not known.");let o=s.tension.indexOf(r),a=s.names[o];return A("p",{},A("strong",{},"Tension")," is largest at ",A("strong",{},Ye(s.s[o],"m",t)),a?" (":"",a?ft(a):null,a?")":""," along the route: ",A("strong",{},Ye(r,"N",t)),". No limit was judged.")}function tR(n){let e=_l(n.run),t=e.filter(s=>s.ok===!1),i=t.length>0?t:e.slice(0,1);return i.length>0?i.map(s=>QC(s,n)):[eR(n)]}var vy=n=>n.charAt(0).toUpperCase()+n.slice(1);function nR(n){let e=n.run.summary.remedies??[],t=e.flatMap(r=>typeof r!="string"&&r.limit==="all"?[r.text]:[]),i=e.flatMap(r=>typeof r=="string"?[r]:r.limit==="all"?[]:[r.text]);return t.length>0&&i.unshift(`${t.join(" and ")} would do, computed by theory with this run's figures: run the case again with it`),i.length>0?i.map(r=>A("p",{},ft(`${vy(Bn(r,n.units))}.`))):_l(n.run).filter(r=>r.ok===!1).map(r=>{let o=Bn(sx(r),n.units)||`its figures alone do not tell what to change; the limit is from: ${r.source}`;return A("p",{},A("strong",{},Vn(r.name)),": ",ft(o),".")})}function iR(n){let{run:e}=n,t=e.summary;switch(xl(e)){case"untrusted":{let s=(t.trust??[]).filter(o=>o.holds===!1).map(o=>A("li",{},A("strong",{},Vn(o.name)),": ",ft(Bn(o.remedy,n.units)))),r=A("p",{},"Make the figures trustworthy first; until then no margin on this page counts.");return s.length>0?[r,A("ul",{},...s)]:[r]}case"unsafe":return[...nR(n),A("p",{class:"detail"},"A remedy is calculated from the figures of this run: compute again with it.")];case"conditional":{let s=(t.limits??[]).filter(r=>[r.friction_most,r.friction_least,r.friction_at_rest_most,r.back_tension_most_N].some(o=>typeof o=="number")).map(r=>A("li",{},A("strong",{},Vn(r.name)),`: depends on ${r.assumed}, which the case does not give`));return[A("p",{},"Give or measure what is assumed, or change the pull until these limits hold:"),A("ul",{},...s)]}case"safe":{let i=(t.limits??[]).filter(r=>r.ok===null),s=i.map(r=>Vn(r.name).toLowerCase()).join(", ");return[A("p",{},"Nothing has to change: every limit that was judged holds."),...i.length>0?[A("p",{class:"detail"},`Not judged: ${s}. The table of limits says what is missing.`)]:[]]}default:{let i=(t.limits??[]).filter(r=>r.ok===null);if(i.length===0)return[A("p",{},"Say what the cable may bear: give the case a section \u201Climits\u201D, and compute again.")];let s=i.map(r=>A("li",{},A("strong",{},Vn(r.name)),": ",ft(Bn(r.source,n.units))));return[A("p",{},"Give the case what is missing, and compute again:"),A("ul",{},...s)]}}}function sR(n){return vy(n.replace(/^(NOT SAFE|NOT TRUSTED|NOT JUDGED|SAFE ONLY IF|SAFE):?\s*/,""))}function by(n){let{run:e,units:t}=n,{summary:i}=e,s=xl(e),r=i.verdict?sR(i.verdict):"These results hold no verdict: they are of an older hawser, or of a run that was cut short.",o=i.outcome==="running"?"The run has not ended, or was killed: this is what it had written by then.":i.outcome&&i.outcome!=="finished"?`The run ended early (${i.outcome}). ${i.message??""}`:"";return A("section",{id:"verdict",class:`verdict ${s}`,"aria-labelledby":"verdict-heading"},A("h2",{id:"verdict-heading"},vr(s),A("span",{},JC[s])),A("p",{class:"reason"},ft(Bn(r,t))),o?A("p",{class:"reason"},ft(Bn(o,t))):null,A("div",{class:"answers"},A("div",{},A("h3",{},"Where it is tightest"),...tR(n)),A("div",{},A("h3",{},"What to change"),...iR(n))))}function My(n,e,t,i){let s=i.map(([r,o])=>{let a=A("input",{type:"radio",name:e,value:r,checked:n.get(e)===r,onchange:()=>n.set(e,r)});return n.subscribe(e,l=>a.checked=l===r),A("label",{},a,A("span",{},o))});return A("fieldset",{class:"choice"},A("legend",{},t),...s)}function Sy(n,e){let t=My(e,"units","Units",[["si","Metric"],["us","US"]]),i=My(e,"theme","Colours",[["light","Light"],["dark","Dark"]]),s=A("div",{class:"toolbar",role:"toolbar","aria-label":"The page"});if(n.runs.length>1){let r=A("select",{id:"run-choice",onchange:()=>e.set("run",Number(r.value))});Ml(n.runs).forEach((o,a)=>r.append(A("option",{value:a},o.slice(0,60)))),e.subscribe("run",o=>r.value=String(o)),s.append(A("label",{class:"run-choice"},"Run ",r))}return s.append(t,i,ni("Print",()=>print(),{class:"print"})),s}var rR=[by,jx,Ux,ty,_y,Yx,Zx],oR=[Kx,my,yy,ry,oy,ay,ly,dy,fy,py],Vh=class{constructor(e,t,i){this.data=t;this.store=i;this.viewSection=A("section",{id:"view","aria-labelledby":"view-heading"},A("h2",{id:"view-heading"},"The pull in three dimensions"),this.viewRoot,this.viewPaper);let s=A("div",{class:"body"},this.before,this.viewSection,this.after);e.replaceChildren(Sy(t,i),this.heading,A("div",{class:"columns"},this.contents,s));for(let r of["units","theme"])i.subscribe(r,()=>this.fill());i.subscribe("run",()=>{this.memory.clear(),this.fill(),this.mount()}),addEventListener("beforeprint",()=>this.print(!0)),addEventListener("afterprint",()=>this.print(!1)),this.fill(),Pl(this.viewRoot,()=>this.mount())}data;store;figures=[];ends=[];memory=new Map;heading=A("header",{class:"page-head"});before=A("div");after=A("div");viewRoot=A("div",{class:"view"});viewPaper=A("div",{class:"on-paper"});viewSection;contents=A("nav",{class:"contents","aria-label":"Contents"});view=null;run(){let e=this.data.runs[this.store.get("run")]??this.data.runs[0];if(!e)throw new Error("The data of this page hold no run.");return e}context(){return{data:this.data,run:this.run(),store:this.store,units:this.store.get("units"),figure:e=>{let t=this.memory.get(e.id)??{zoom:null,hidden:new Set,open:!1};this.memory.set(e.id,t);let i=new So(e,this.store,t);return this.figures.push(i),i.element},onDispose:e=>this.ends.push(e)}}fill(){for(let o of this.figures)o.dispose();for(let o of this.ends)o();this.figures=[],this.ends=[];let e=this.context(),{run:t}=e,i=[this.before,this.after].map(o=>[o,o.offsetHeight]);for(let[o,a]of i)o.style.minHeight=`${a}px`;let s=o=>o.map(a=>a(e)).filter(a=>a!==null);this.before.replaceChildren(...s(rR)),this.after.replaceChildren(...s(oR)),requestAnimationFrame(()=>i.forEach(([o])=>o.style.minHeight=""));let r=t.summary.version?`simulated with hawser ${t.summary.version}`:"";this.heading.replaceChildren(A("p",{class:"kind"},"Report of a cable pull"),A("h1",{},ft(dp(t))),A("p",{class:"by"},ft(t.summary.case??t.label),r?` \xB7 ${r}`:""),...(t.notes??[]).map(o=>A("p",{class:"note"},ft(o)))),document.title=`${dp(t).slice(0,120)} \xB7 hawser`,this.list()}list(){let t=[...document.querySelectorAll("main section[id]")].map(i=>{let s=i.id==="verdict"?"Verdict":i.querySelector("h2")?.textContent??"";return A("li",{},A("a",{href:`#${i.id}`},s))});this.contents.replaceChildren(A("ul",{},...t))}mount(){this.view?.dispose(),this.view=null;let e=this.run();if(!e.states&&!e.geometry){this.viewRoot.replaceChildren(mn("These results hold neither states of the cable nor the geometry of the route, so there is nothing to play."));return}try{this.view=Ph(this.viewRoot,e,this.store,Wp(this.data.runs,e))}catch(t){let i=t instanceof Error?t.message:String(t);this.viewRoot.replaceChildren(mn(`The view could not be made here: ${i}`))}}print(e){for(let i of this.figures)i.print(e);let t=e?this.view?.onPaper()??null:null;this.viewPaper.replaceChildren(...t?[t]:[]);for(let i of document.querySelectorAll("details.long"))e&&(i.open=!0)}};function aR(n){let e=matchMedia("(prefers-color-scheme: dark)"),t=e.matches?"dark":"light",i=new wo({place:null,time:null,units:"si",theme:t,run:0,roller:null}),s=()=>{document.documentElement.dataset.theme=i.get("theme")};s(),i.subscribe("theme",s),e.addEventListener("change",()=>i.set("theme",e.matches?"dark":"light")),new Vh(n,Xp(document),i)}Object.assign(window,{hawserLive:Ax});var wp=document.getElementById("hawser");if(wp)try{aR(wp)}catch(n){throw wp.replaceChildren(A("p",{class:"failed",role:"alert"},n instanceof Error?n.message:String(n))),n}})();
