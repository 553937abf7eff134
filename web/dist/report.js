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
"use strict";(()=>{function wp(n){let e=n.getElementById("hawser-data")?.textContent;if(!e)throw new Error("This page holds no data of a run.");let t=JSON.parse(e);if(t.format!==1)throw new Error(`The data of this page are of format ${String(t.format)}; the page reads 1.`);if(!Array.isArray(t.runs)||t.runs.length===0)throw new Error("The data of this page hold no run.");return t}var rv="http://www.w3.org/2000/svg";function Ep(n,e,t){for(let[i,s]of Object.entries(e))typeof s=="function"?n.addEventListener(i.slice(2),s):s===!0?n.setAttribute(i,""):s!==!1&&s!==null&&s!==void 0&&n.setAttribute(i,String(s));for(let i of t)i&&n.append(i)}function I(n,e={},...t){let i=document.createElement(n);return Ep(i,e,t),i}function it(n,e={},...t){let i=document.createElementNS(rv,n);return Ep(i,e,t),i}var Tp=160;function mt(n){let e=String(n??"");return e.length<=Tp?I("bdi",{class:"name"},e):I("bdi",{class:"name",title:e.slice(0,2e3)},`${e.slice(0,Tp)}\u2026`)}function jn(n,e,t={}){return I("button",{type:"button",onclick:e,...t},n)}function Bs(n){let e=new Set;for(let r of n)for(let o of r.x)o!==null&&Number.isFinite(o)&&e.add(o);let t=[...e].sort((r,o)=>r-o),i=new Map(t.map((r,o)=>[r,o])),s=n.map(r=>{let o=new Array(t.length).fill(void 0);return r.x.forEach((a,l)=>{let c=a===null?void 0:i.get(a);c!==void 0&&(o[c]=r.y[l]??null)}),o});return{x:t,y:s}}function ov(n,e){let t=0,i=n.length;for(;t<i;){let s=t+i>>1;n[s]<=e?t=s+1:i=s}return t-1}function vr(n,e,t){let i=ov(n,t);for(;i>=0&&e[i]===void 0;)i-=1;if(i<0)return null;let s=e[i];if(s==null)return null;let r=n[i];if(r===t)return s;let o=i+1;for(;o<n.length&&e[o]===void 0;)o+=1;let a=e[o];return a==null?null:s+(a-s)*(t-r)/(n[o]-r)}function Dh(n,e,t){let i=null,s=1/0;return n.forEach((r,o)=>{let a=r===null?1/0:Math.abs(r-t);a<s&&e[o]!==null&&e[o]!==void 0&&(s=a,i=e[o])}),i}function un(n){let e=1/0,t=-1/0;for(let i of n)i==null||!Number.isFinite(i)||(e=Math.min(e,i),t=Math.max(t,i));return e>t?null:[e,t]}var yl=4.4482216152605,av={N:[{symbol:"kN",factor:.001,from:1e3},{symbol:"N",factor:1,from:0}],"N/m":[{symbol:"kN/m",factor:.001,from:2e3},{symbol:"N/m",factor:1,from:0}],mm:[{symbol:"mm",factor:1e3,from:0}],"N m":[{symbol:"kN m",factor:.001,from:1e4},{symbol:"N m",factor:1,from:0}]},lv={N:{symbol:"lbf",factor:1/yl},"N/m":{symbol:"lbf/ft",factor:.3048/yl},m:{symbol:"ft",factor:1/.3048},mm:{symbol:"in",factor:12/.3048},"m/s":{symbol:"ft/min",factor:60/.3048},"N m":{symbol:"lbf ft",factor:1/(yl*.3048)},W:{symbol:"ft lbf/s",factor:1/(yl*.3048)},"1/m":{symbol:"1/ft",factor:.3048}};function Gt(n,e,t){let i=lv[n];if(e==="us"&&i)return i;let r=av[n]?.find(({from:o})=>Math.abs(t)>=o);return r?{symbol:r.symbol,factor:r.factor}:{symbol:n==="1"?"":n,factor:1}}function Fh(n){let[e="",t]=n.replace("-","\u2212").split("."),s=e.replace(/\D/g,"").length>4?e.replace(/\B(?=(\d{3})+$)/g,"\u202F"):e;return t?`${s}.${t}`:s}function hn(n,e=4){if(n===0)return"0";let t=Math.floor(Math.log10(Math.abs(n)));if(t<-5||t>8)return n.toExponential(e-1);let i=Math.max(0,e-1-t),s=n.toFixed(Math.min(i,12));return Fh(s.includes(".")?s.replace(/\.?0+$/,""):s)}var si="not known";function Ke(n,e,t,i=4){if(n==null||Number.isNaN(n))return si;if(e==="%")return`${hn(n,i)}\u202F%`;let{symbol:s,factor:r}=Gt(e,t,n);return s?`${hn(n*r,i)}\xA0${s}`:hn(n*r,i)}function bl(n){return["N","N/m","m","mm","m/s","s","1","%","N m","W","rad/s","1/m"].includes(n)}function no(n,e){let t=/^(-?\d+(?:\.\d+)?) m\b(.*)$/s.exec(n);return t?Ke(Number(t[1]),"m",e)+(t[2]??""):n}var cv={text:"#1b1f24",muted:"#57606a",grid:"#e3e7eb",paper:"#ffffff",limit:"#c04a00",event:"#7a5195",window:"rgba(0, 114, 178, 0.07)",band:"rgba(0, 114, 178, 0.16)",curve:{simulated:"#0072b2",peak:"#0072b2",envelope:"#5aa9d6",theory:"#1b1f24",backward:"#8a6d00",paper:"#b3437c",second:"#c98a00",third:"#007f5f",fourth:"#b3437c",fifth:"#3f8fc0",sixth:"#57606a",ground:"#57606a",route:"#1b1f24"}},uv={text:"#e6eaee",muted:"#9aa5b1",grid:"#2b323a",paper:"#161b21",limit:"#ff8a4c",event:"#c3a1dd",window:"rgba(86, 180, 233, 0.09)",band:"rgba(86, 180, 233, 0.22)",curve:{simulated:"#56b4e9",peak:"#56b4e9",envelope:"#3b7ea8",theory:"#e6eaee",backward:"#d9bf4d",paper:"#e39ac4",second:"#e69f00",third:"#2fc59a",fourth:"#e39ac4",fifth:"#8fc7ea",sixth:"#9aa5b1",ground:"#9aa5b1",route:"#e6eaee"}},ki=n=>n==="dark"?uv:cv,io={simulated:[],peak:[1,3],envelope:[],theory:[7,4],backward:[2,3],paper:[9,3,2,3],second:[6,3],third:[2,2],fourth:[9,3,2,3],fifth:[12,4],sixth:[4,2,1,2],ground:[],route:[]},so={simulated:2,peak:1.5,envelope:1,theory:1.5,backward:1.5,paper:1.5,second:1.5,third:1.5,fourth:1.5,fifth:1.5,sixth:1.5,ground:1.5,route:1.5},ks=["simulated","second","third","fourth","fifth","sixth"];var hv=2.5;function yr(n){let e=Math.max(0,...n.curves.map(t=>un(t.y)?.[1]??0));return(n.levels??[]).filter(({value:t})=>t<=hv*e||e===0)}function Ml(n,e,t){let i=[e,t,...yr(n).map(({value:l})=>l),...n.fromZero===!1?[]:[0]],s=Math.max(0,(n.span??0)-(Math.max(...i)-Math.min(...i)))/2,[r,o]=[Math.min(...i)-s,Math.max(...i)+s],a=(o-r||Math.abs(o)||1)*.06;return[r===0?0:r-a,o===0&&r<0?0:o+a]}function Ap(n,e,t,i){let s=(o,a)=>n.x[a]>=e&&n.x[a]<=t,r=n.y.flatMap((o,a)=>i.has(a)?[]:un(o.filter(s))??[]);return un(r)??[0,1]}function ro(n,e,t){let i=e-n;if(!(i>0))return[n];let s=i/Math.max(1,t),r=10**Math.floor(Math.log10(s)),o=[1,2,5,10].map(l=>l*r).find(l=>l>=s*.999)??s,a=[];for(let l=Math.ceil(n/o-1e-9);l*o<=e+1e-9*i;l+=1)a.push(l*o);return a}function aa(n){let e=n.length>1?Math.abs(n[1]-n[0]):1,t=Math.max(0,Math.min(8,-Math.floor(Math.log10(e)+1e-9)));return n.map(i=>Fh(Math.abs(i)<e*1e-6?"0":i.toFixed(t)))}var Sl={place:"m",time:"s",head:"m"};function dv(n,e){let t=ki(e).curve[n.role],i=n.points?it("circle",{cx:13,cy:6,r:3,fill:ki(e).paper,stroke:t,"stroke-width":1.5}):it("path",{d:"M1 6H25",stroke:t,"stroke-width":so[n.role],"stroke-dasharray":io[n.role].join(" ")||null});return it("svg",{width:26,height:12,"aria-hidden":"true",class:"swatch"},i)}function Cp(n){return it("svg",{width:26,height:12,"aria-hidden":"true",class:"swatch"},it("rect",{x:2,y:1,width:22,height:10,fill:n}))}function fv(n){return it("svg",{width:26,height:12,"aria-hidden":"true",class:"swatch"},it("path",{d:"M1 6H25",stroke:n,"stroke-width":2}))}function Rp(n,e,t,i){let s=ki(i.theme),r=I("span",{class:"legend-at"}),o=[],a=I("ul",{class:"legend","aria-label":"Curves"});n.curves.forEach((u,d)=>{if(u.quiet){o.push(null);return}let h=I("span",{class:"legend-value"});o.push(h);let f=!i.hidden.has(d),m=I("button",{type:"button",class:"legend-item","aria-pressed":String(f),onclick:()=>i.onToggle(d)},dv(u,i.theme),I("bdi",{},u.label));a.append(I("li",{},m,h))}),n.band&&a.append(I("li",{},I("span",{class:"legend-item"},Cp(s.band),n.band.label)));let l=new Set(yr(n));for(let u of n.levels??[]){let d=l.has(u)?"":" (above the figure)",h=`${u.label}: ${Ke(u.value,n.yUnit,i.units)}${d}`;a.append(I("li",{},I("span",{class:"legend-item"},fv(s.limit),h)))}n.window&&a.append(I("li",{},I("span",{class:"legend-item"},Cp(s.window),n.window.label)));let c="";return{element:I("div",{class:"legend-row"},a,r),update(u){let d=[];n.curves.forEach((h,f)=>{let m=u===null?null:vr(e.x,e.y[f]??[],u),v=m===null?"":`${hn(m*t.factor)}\xA0${t.symbol}`.trim(),g=o[f];g&&(g.textContent=v),v&&g&&d.push(`${h.label} ${v}`)}),r.textContent=u===null?"":`at ${Ke(u,Sl[n.along],i.units)}`,c=u===null?"":`${r.textContent}: ${d.join(", ")||"nothing known"}`},sentence:()=>c}}function wl(n,e){if(n.along==="place")return e.get("place");let t=e.get("time");return n.along==="time"||t===null?t:n.clock?Dh(n.clock.time,n.clock.head,t):null}function Oh(n,e,t,i){if(n.along==="place")e.set("place",t,i);else if(t!==null&&n.along==="time")e.set("time",t,i);else if(n.along==="head"){e.set("place",t,i);let s=t===null||!n.clock?null:Dh(n.clock.head,n.clock.time,t);s!==null&&e.set("time",s,i)}}function Pp(n,e){let{chart:t,xScale:i}=n,s=e===null?-10:t.valToPos(e*i.factor,"x"),r=s>=0&&s<=t.over.clientWidth;t.setCursor({left:r?s:-10,top:r?10:-10},!1)}function Uh(n,e,t,i){let s=Math.max(e[0],t-(t-n[0])*i),r=Math.min(e[1],t+(n[1]-t)*i);return r-s<(e[1]-e[0])*1e-4?n:[s,r]}function Ip(n,e){if(n.ctrlKey||n.metaKey||n.altKey)return;let t=e.view(),i=e.cursor()??(t[0]+t[1])/2,s=(t[1]-t[0])/100*(n.shiftKey?10:1),r=l=>Math.min(t[1],Math.max(t[0],l)),a={ArrowLeft:()=>e.move(r(i-s)),ArrowRight:()=>e.move(r(i+s)),Home:()=>e.move(t[0]),End:()=>e.move(t[1]),"+":()=>e.zoom(Uh(t,e.reach(),r(i),.5)),"=":()=>e.zoom(Uh(t,e.reach(),r(i),.5)),"-":()=>e.zoom(Uh(t,e.reach(),r(i),2)),0:()=>e.zoom(e.reach())}[n.key];a&&(n.preventDefault(),a())}var pv="uplot",mv="u-hz",gv="u-vt",_v="u-title",xv="u-wrap",vv="u-under",yv="u-over",bv="u-axis",Sr="u-off",Mv="u-select",Sv="u-cursor-x",wv="u-cursor-y",Tv="u-cursor-pt",Ev="u-legend",Av="u-live",Cv="u-inline",Rv="u-series",Pv="u-marker",Lp="u-label",Iv="u-value",ca="width",ua="height";var Np="bottom",oo="left",Bh="right",td="#000",Dp=td+"0",kh="mousemove",Fp="mousedown",Vh="mouseup",Up="mouseenter",Op="mouseleave",Bp="dblclick",Lv="resize",Nv="scroll",kp="change",Rl="dppxchange",nd="--",po=typeof window<"u",Xh=po?document:null,lo=po?window:null,Dv=po?navigator:null,At,Tl;function qh(){let n=devicePixelRatio;At!=n&&(At=n,Tl&&$h(kp,Tl,qh),Tl=matchMedia(`(min-resolution: ${At-.001}dppx) and (max-resolution: ${At+.001}dppx)`),wr(kp,Tl,qh),lo.dispatchEvent(new CustomEvent(Rl)))}function mi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Yh(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Kt(n,e,t){n.style[e]=t+"px"}function Vi(n,e,t,i){let s=Xh.createElement(n);return e!=null&&mi(s,e),t?.insertBefore(s,i),s}function Ri(n,e){return Vi("div",n,e)}var Vp=new WeakMap;function is(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Vp.get(n);r!=o&&(n.style.transform=r,Vp.set(n,r),e<0||t<0||e>i||t>s?mi(n,Sr):Yh(n,Sr))}var zp=new WeakMap;function Gp(n,e,t){let i=e+t,s=zp.get(n);i!=s&&(zp.set(n,i),n.style.background=e,n.style.borderColor=t)}var Hp=new WeakMap;function Wp(n,e,t,i){let s=e+""+t,r=Hp.get(n);s!=r&&(Hp.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var id={passive:!0},Fv={...id,capture:!0};function wr(n,e,t,i){e.addEventListener(n,t,i?Fv:id)}function $h(n,e,t,i){e.removeEventListener(n,t,id)}po&&qh();function zi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:gi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function xm(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var vm=n=>n!=null,ym=n=>n!=null&&n>0,Ll=xm(vm),Uv=xm(ym);function Ov(n,e,t,i=0,s=!1){let r=s?Uv:Ll,o=s?ym:vm;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ht,l??-Ht]}function Nl(n,e,t,i){let s=Yp(n),r=Yp(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?gs:bm,a=s==1?gi:Pi,l=r==1?Pi:gi,c=a(o(Sn(n))),u=l(o(Sn(e))),d=co(t,c),h=co(t,u);return t==10&&(c<0&&(d=Wt(d,-c)),u<0&&(h=Wt(h,-u))),i||t==2?(n=d*s,e=h*r):(n=Tm(n,d),e=Dl(e,h)),[n,e]}function sd(n,e,t,i){let s=Nl(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var rd=.1,Xp={mode:3,pad:rd},da={pad:0,soft:null,mode:0},Bv={min:da,max:da};function Pl(n,e,t,i){return Fl(t)?qp(n,e,t):(da.pad=t,da.soft=i?0:null,da.mode=i?3:0,qp(n,e,Bv))}function bt(n,e){return n??e}function kv(n,e,t){for(e=bt(e,0),t=bt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function qp(n,e,t){let i=t.min,s=t.max,r=bt(i.pad,0),o=bt(s.pad,0),a=bt(i.hard,-Ht),l=bt(s.hard,Ht),c=bt(i.soft,Ht),u=bt(s.soft,-Ht),d=bt(i.mode,0),h=bt(s.mode,0),f=e-n,m=gs(f),v=Qn(Sn(n),Sn(e)),g=gs(v),p=Sn(g-m);(f<1e-24||p>10)&&(f=0,(n==0||e==0)&&(f=1e-24,d==2&&c!=Ht&&(r=0),h==2&&u!=-Ht&&(o=0)));let S=f||v||1e3,C=gs(S),b=co(10,gi(C)),E=S*(f==0?n==0?.1:1:r),T=Wt(Tm(n-E,b/10),24),D=n>=c&&(d==1||d==3&&T<=c||d==2&&T>=c)?c:Ht,y=Qn(a,T<D&&n>=D?D:Gi(D,T)),A=S*(f==0?e==0?.1:1:o),F=Wt(Dl(e+A,b/10),24),L=e<=u&&(h==1||h==3&&F>=u||h==2&&F<=u)?u:-Ht,U=Gi(l,F>L&&e<=L?L:Qn(L,F));return y==U&&y==0&&(U=100),[y,U]}var Vv=new Intl.NumberFormat(po?Dv.language:"en-US"),od=n=>Vv.format(n),_i=Math,Cl=_i.PI,Sn=_i.abs,gi=_i.floor,Mn=_i.round,Pi=_i.ceil,Gi=_i.min,Qn=_i.max,co=_i.pow,Yp=_i.sign,gs=_i.log10,bm=_i.log2,zv=(n,e=1)=>_i.sinh(n)*e,zh=(n,e=1)=>_i.asinh(n/e),Ht=1/0;function $p(n){return(gs((n^n>>31)-(n>>31))|0)+1}function Zh(n,e,t){return Gi(Qn(n,e),t)}function Mm(n){return typeof n=="function"}function gt(n){return Mm(n)?n:()=>n}var Gv=()=>{},Sm=n=>n,wm=(n,e)=>e,Hv=n=>null,Zp=n=>!0,Kp=(n,e)=>n==e,Wv=/\.\d*?(?=9{6,}|0{6,})/gm,Tr=n=>{if(Am(n)||zs.has(n))return n;let e=`${n}`,t=e.match(Wv);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Tr(s)}e${r}`}return Wt(n,i)};function br(n,e){return Tr(Wt(Tr(n/e))*e)}function Dl(n,e){return Tr(Pi(Tr(n/e))*e)}function Tm(n,e){return Tr(gi(Tr(n/e))*e)}function Wt(n,e=0){if(Am(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Mn(i)/t}var zs=new Map;function Em(n){return((""+n).split(".")[1]||"").length}function pa(n,e,t,i){let s=[],r=i.map(Em);for(let o=e;o<t;o++){let a=Sn(o),l=Wt(co(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:Wt(u,d);s.push(h),zs.set(h,d)}}return s}var fa={},ad=[],uo=[null,null],Vs=Array.isArray,Am=Number.isInteger,Xv=n=>n===void 0;function Jp(n){return typeof n=="string"}function Fl(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function qv(n){return n!=null&&typeof n=="object"}var Yv=Object.getPrototypeOf(Uint8Array),Cm="__proto__";function ho(n,e=Fl){let t;if(Vs(n)){let i=n.find(s=>s!=null);if(Vs(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=ho(n[s],e)}else t=n.slice()}else if(n instanceof Yv)t=n.slice();else if(e(n)){t={};for(let i in n)i!=Cm&&(t[i]=ho(n[i],e))}else t=n;return t}function _n(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=Cm&&(Fl(n[s])?_n(n[s],ho(i[s])):n[s]=ho(i[s]))}return n}var $v=0,Zv=1,Kv=2;function Jv(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function jv(n,e){if(ty(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return ny(o[0])||(o=ey(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],d=Array(s).fill(void 0),h=e?e[o][c]:Zv,f=[];for(let m=0;m<u.length;m++){let v=u[m],g=r.get(l[m]);v===null?h!=$v&&(d[g]=v,h==Kv&&f.push(g)):d[g]=v}Jv(d,f,s),i.push(d)}}return i}var Qv=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function ey(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function ty(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function ny(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Qn(1,gi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Rm=["January","February","March","April","May","June","July","August","September","October","November","December"],Pm=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Im(n){return n.slice(0,3)}var iy=Pm.map(Im),sy=Rm.map(Im),ry={MMMM:Rm,MMM:sy,WWWW:Pm,WWW:iy};function la(n){return(n<10?"0":"")+n}function oy(n){return(n<10?"00":n<100?"0":"")+n}var ay={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>la(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>la(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>la(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>la(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>la(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>oy(n.getMilliseconds())};function ld(n,e){e=e||ry;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?ay[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var ly=new Intl.DateTimeFormat().resolvedOptions().timeZone;function cy(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==ly?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var Lm=n=>n%1==0,Il=[1,2,2.5,5],uy=pa(10,-32,0,Il),Nm=pa(10,0,32,Il),hy=Nm.filter(Lm),Mr=uy.concat(Nm),cd=`
`,Dm="{YYYY}",jp=cd+Dm,Fm="{M}/{D}",ha=cd+Fm,El=ha+"/{YY}",Um="{aa}",dy="{h}:{mm}",ao=dy+Um,Qp=cd+ao,em=":{ss}",Rt=null;function Om(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?pa(10,0,3,Il).filter(Lm):pa(10,-3,0,Il)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Dm,Rt,Rt,Rt,Rt,Rt,Rt,1],[s*28,"{MMM}",jp,Rt,Rt,Rt,Rt,Rt,1],[s,Fm,jp,Rt,Rt,Rt,Rt,Rt,1],[i,"{h}"+Um,El,Rt,ha,Rt,Rt,Rt,1],[t,ao,El,Rt,ha,Rt,Rt,Rt,1],[e,em,El+" "+ao,Rt,ha+" "+ao,Rt,Qp,Rt,1],[n,em+".{fff}",El+" "+ao,Rt,ha+" "+ao,Rt,Qp,Rt,1]];function u(d){return(h,f,m,v,g,p)=>{let S=[],C=g>=o,b=g>=r&&g<o,E=d(m),T=Wt(E*n,3),D=Gh(E.getFullYear(),C?0:E.getMonth(),b||C?1:E.getDate()),y=Wt(D*n,3);if(b||C){let A=b?g/r:0,F=C?g/o:0,L=T==y?T:Wt(Gh(D.getFullYear()+F,D.getMonth()+A,1)*n,3),U=new Date(Mn(L/n)),G=U.getFullYear(),q=U.getMonth();for(let O=0;L<=v;O++){let Y=Gh(G+F*O,q+A*O,1),H=Y-d(Wt(Y*n,3));L=Wt((+Y+H)*n,3),L<=v&&S.push(L)}}else{let A=g>=s?s:g,F=gi(m)-gi(T),L=y+F+Dl(T-y,A);S.push(L);let U=d(L),G=U.getHours()+U.getMinutes()/t+U.getSeconds()/i,q=g/i,O=h.axes[f]._space,Y=p/O;for(;L=Wt(L+g,n==1?0:3),!(L>v);)if(q>1){let H=gi(Wt(G+q,6))%24,le=d(L).getHours()-H;le>1&&(le=-1),L-=le*i,G=(G+q)%24;let de=S[S.length-1];Wt((L-de)/g,3)*Y>=.7&&S.push(L)}else S.push(L)}return S}}return[l,c,u]}var[fy,py,my]=Om(1),[gy,_y,xy]=Om(.001);pa(2,-53,53,[1]);function tm(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function nm(n,e){return(t,i,s,r,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,u,d,h,f;return i.map(m=>{let v=n(m),g=v.getFullYear(),p=v.getMonth(),S=v.getDate(),C=v.getHours(),b=v.getMinutes(),E=v.getSeconds(),T=g!=l&&a[2]||p!=c&&a[3]||S!=u&&a[4]||C!=d&&a[5]||b!=h&&a[6]||E!=f&&a[7]||a[1];return l=g,c=p,u=S,d=C,h=b,f=E,T(v)})}}function vy(n,e){let t=ld(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Gh(n,e,t){return new Date(n,e,t)}function im(n,e){return e(n)}var yy="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function sm(n,e){return(t,i,s,r)=>r==null?nd:e(n(i))}function by(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function My(n,e){return n.series[e].fill(n,e)}var Sy={show:!0,live:!0,isolate:!1,mount:Gv,markers:{show:!0,width:2,stroke:by,fill:My,dash:"solid"},idx:null,idxs:null,values:[]};function wy(n,e){let t=n.cursor.points,i=Ri(),s=t.size(n,e);Kt(i,ca,s),Kt(i,ua,s);let r=s/-2;Kt(i,"marginLeft",r),Kt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Kt(i,"borderWidth",o),i}function Ty(n,e){let t=n.series[e].points;return t._fill||t._stroke}function Ey(n,e){let t=n.series[e].points;return t._stroke||t._fill}function Ay(n,e){return n.series[e].points.size}var Hh=[0,0];function Cy(n,e,t){return Hh[0]=e,Hh[1]=t,Hh}function Al(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Wh(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var Ry={show:!0,x:!0,y:!0,lock:!1,move:Cy,points:{one:!1,show:wy,size:Ay,width:0,stroke:Ey,fill:Ty},bind:{mousedown:Al,mouseup:Al,click:Al,dblclick:Al,mousemove:Wh,mouseleave:Wh,mouseenter:Wh},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Bm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},ud=_n({},Bm,{filter:wm}),km=_n({},ud,{size:10}),Vm=_n({},Bm,{show:!1}),hd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',zm="bold "+hd,Gm=1.5,rm={show:!0,scale:"x",stroke:td,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:zm,side:2,grid:ud,ticks:km,border:Vm,font:hd,lineGap:Gm,rotate:0},Py="Value",Iy="Time",om={show:!0,scale:"x",auto:!1,sorted:1,min:Ht,max:-Ht,idxs:[]};function Ly(n,e,t,i,s){return e.map(r=>r==null?"":od(r))}function Ny(n,e,t,i,s,r,o){let a=[],l=zs.get(s)||0;t=o?t:Wt(Dl(t,s),l);for(let c=t;c<=i;c=Wt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Kh(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?gs:bm,u=gi(c(t));s=co(l,u),l==10&&(s=Mr[zi(s,Mr)]);let d=t,h=s*l;l==10&&(h=Mr[zi(h,Mr)]);do a.push(d),d=d+s,l==10&&!zs.has(d)&&(d=Wt(d,zs.get(s))),d>=h&&(s=d,h=s*l,l==10&&(h=Mr[zi(h,Mr)]));while(d<=i);return a}function Dy(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Kh(n,e,Qn(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Kh(n,e,Qn(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var Hm=/./,Fy=/[12357]/,Uy=/[125]/,am=/1/,Jh=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Oy(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),d=l(9,o)-u>=c?Hm:l(7,o)-u>=c?Fy:l(5,o)-u>=c?Uy:am;if(d==am){let h=Sn(l(1,o)-u);if(h<c)return Jh(e.slice().reverse(),a.distr,d,Pi(c/h)).reverse()}return Jh(e,a.distr,d,1)}function By(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=Sn(l(1,o)-l(2,o));return c<a?Jh(e.slice().reverse(),3,Hm,Pi(a/c)).reverse():e}function ky(n,e,t,i){return i==null?nd:e==null?"":od(e)}var lm={show:!0,scale:"y",stroke:td,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:zm,side:3,grid:ud,ticks:km,border:Vm,font:hd,lineGap:Gm,rotate:0};function Vy(n,e){let t=3+(n||1)*2;return Wt(t*e,3)}function zy(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=Sn(o-r),l=n.series[e],c=a/(l.points.space*At);return i[1]-i[0]<=c}var cm={scale:null,auto:!0,sorted:0,min:Ht,max:-Ht},Wm=(n,e,t,i,s)=>s,um={show:!0,auto:!0,sorted:0,gaps:Wm,alpha:1,facets:[_n({},cm,{scale:"x"}),_n({},cm,{scale:"y"})]},hm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Wm,alpha:1,points:{show:zy,filter:null},values:null,min:Ht,max:-Ht,idxs:[],path:null,clip:null};function Gy(n,e,t,i,s){return t/10}var Xm={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Hy=_n({},Xm,{time:!1,ori:1}),dm={};function qm(n,e){let t=dm[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(dm[n]=t)),t}var fo=1,jh=2;function Er(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],d=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,f=a.top,m=a.width,v=a.height,g=n.valToPosH,p=n.valToPosV;return u.ori==0?t(s,l,c,u,d,g,p,h,f,m,v,Ol,mo,kl,$m,Km):t(s,l,c,u,d,p,g,f,h,v,m,Bl,go,pd,Zm,Jm)}function dd(n,e){let t=0,i=0,s=bt(n.bands,ad);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function Wy(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function _s(n,e,t,i,s,r){return Er(n,e,(o,a,l,c,u,d,h,f,m,v,g)=>{let p=o.pxRound,S=c.dir*(c.ori==0?1:-1),C=c.ori==0?mo:go,b,E;S==1?(b=t,E=i):(b=i,E=t);let T=p(d(a[b],c,v,f)),D=p(h(l[b],u,g,m)),y=p(d(a[E],c,v,f)),A=p(h(r==1?u.max:u.min,u,g,m)),F=new Path2D(s);return C(F,y,A),C(F,T,A),C(F,T,D),F})}function Ul(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?kl:pd,l=t;for(let d=0;d<n.length;d++){let h=n[d];if(h[1]>h[0]){let f=h[0]-l;f>0&&a(o,l,i,f,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function Xy(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function fd(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let d=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let f=r(n[d]),m=h==d?f:r(n[h]),v=d-s;f=o<=0&&v>=0&&v<l?r(n[v]):f;let p=h+s;m=o>=0&&p>=0&&p<l?r(n[p]):m,m>=f&&a.push([f,m])}return a}function fm(n){return n==0?Sm:n==1?Mn:e=>br(e,n)}function Ym(n){let e=n==0?Ol:Bl,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Gi(c,a/2,l/2),u=Gi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Ol=(n,e,t)=>{n.moveTo(e,t)},Bl=(n,e,t)=>{n.moveTo(t,e)},mo=(n,e,t)=>{n.lineTo(e,t)},go=(n,e,t)=>{n.lineTo(t,e)},kl=Ym(0),pd=Ym(1),$m=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},Zm=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},Km=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Jm=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function jm(n){return(e,t,i,s,r)=>Er(e,t,(o,a,l,c,u,d,h,f,m,v,g)=>{let{pxRound:p,points:S}=o,C,b;c.ori==0?(C=Ol,b=$m):(C=Bl,b=Zm);let E=Wt(S.width*At,3),T=(S.size-S.width)/2*At,D=Wt(T*2,3),y=new Path2D,A=new Path2D,{left:F,top:L,width:U,height:G}=e.bbox;kl(A,F-D,L-D,U+D*2,G+D*2);let q=O=>{if(l[O]!=null){let Y=p(d(a[O],c,v,f)),H=p(h(l[O],u,g,m));C(y,Y+T,H),b(y,Y,H,T,0,Cl*2)}};if(r)r.forEach(q);else for(let O=i;O<=s;O++)q(O);return{stroke:E>0?y:null,fill:y,clip:A,flags:fo|jh}})}function Qm(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var qy=Qm(mo),Yy=Qm(go);function eg(n){let e=bt(n?.alignGaps,0);return(t,i,s,r)=>Er(t,i,(o,a,l,c,u,d,h,f,m,v,g)=>{[s,r]=Ll(l,s,r);let p=o.pxRound,S=G=>p(d(G,c,v,f)),C=G=>p(h(G,u,g,m)),b,E;c.ori==0?(b=mo,E=qy):(b=go,E=Yy);let T=c.dir*(c.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:fo},y=D.stroke,A=!1;if(r-s>=v*4){let G=_e=>t.posToVal(_e,c.key,!0),q=null,O=null,Y,H,ie,oe=S(a[T==1?s:r]),le=S(a[s]),de=S(a[r]),ue=G(T==1?le+1:de-1);for(let _e=T==1?s:r;_e>=s&&_e<=r;_e+=T){let st=a[_e],Q=(T==1?st<ue:st>ue)?oe:S(st),ae=l[_e];Q==oe?ae!=null?(H=ae,q==null?(b(y,Q,C(H)),Y=q=O=H):H<q?q=H:H>O&&(O=H)):ae===null&&(A=!0):(q!=null&&E(y,oe,C(q),C(O),C(Y),C(H)),ae!=null?(H=ae,b(y,Q,C(H)),q=O=Y=H):(q=O=null,ae===null&&(A=!0)),oe=Q,ue=G(oe+T))}q!=null&&q!=O&&ie!=oe&&E(y,oe,C(q),C(O),C(Y),C(H))}else for(let G=T==1?s:r;G>=s&&G<=r;G+=T){let q=l[G];q===null?A=!0:q!=null&&b(y,S(a[G]),C(q))}let[L,U]=dd(t,i);if(o.fill!=null||L!=0){let G=D.fill=new Path2D(y),q=o.fillTo(t,i,o.min,o.max,L),O=C(q),Y=S(a[s]),H=S(a[r]);T==-1&&([H,Y]=[Y,H]),b(G,H,O),b(G,Y,O)}if(!o.spanGaps){let G=[];A&&G.push(...fd(a,l,s,r,T,S,e)),D.gaps=G=o.gaps(t,i,s,r,G),D.clip=Ul(G,c.ori,f,m,v,g)}return U!=0&&(D.band=U==2?[_s(t,i,s,r,y,-1),_s(t,i,s,r,y,1)]:_s(t,i,s,r,y,U)),D})}function $y(n){let e=bt(n.align,1),t=bt(n.ascDesc,!1),i=bt(n.alignGaps,0),s=bt(n.extend,!1);return(r,o,a,l)=>Er(r,o,(c,u,d,h,f,m,v,g,p,S,C)=>{[a,l]=Ll(d,a,l);let b=c.pxRound,{left:E,width:T}=r.bbox,D=le=>b(m(le,h,S,g)),y=le=>b(v(le,f,C,p)),A=h.ori==0?mo:go,F={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:fo},L=F.stroke,U=h.dir*(h.ori==0?1:-1),G=y(d[U==1?a:l]),q=D(u[U==1?a:l]),O=q,Y=q;s&&e==-1&&(Y=E,A(L,Y,G)),A(L,q,G);for(let le=U==1?a:l;le>=a&&le<=l;le+=U){let de=d[le];if(de==null)continue;let ue=D(u[le]),_e=y(de);e==1?A(L,ue,G):A(L,O,_e),A(L,ue,_e),G=_e,O=ue}let H=O;s&&e==1&&(H=E+T,A(L,H,G));let[ie,oe]=dd(r,o);if(c.fill!=null||ie!=0){let le=F.fill=new Path2D(L),de=c.fillTo(r,o,c.min,c.max,ie),ue=y(de);A(le,H,ue),A(le,Y,ue)}if(!c.spanGaps){let le=[];le.push(...fd(u,d,a,l,U,D,i));let de=c.width*At/2,ue=t||e==1?de:-de,_e=t||e==-1?-de:de;le.forEach(st=>{st[0]+=ue,st[1]+=_e}),F.gaps=le=c.gaps(r,o,a,l,le),F.clip=Ul(le,h.ori,g,p,S,C)}return oe!=0&&(F.band=oe==2?[_s(r,o,a,l,L,-1),_s(r,o,a,l,L,1)]:_s(r,o,a,l,L,oe)),F})}function pm(n,e,t,i,s,r,o=Ht){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Sn(n[l]-n[a]);u<c&&(c=u,o=Sn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function Zy(n){n=n||fa;let e=bt(n.size,[.6,Ht,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=gt(s),o=1-e[0],a=bt(e[1],Ht),l=bt(e[2],1),c=bt(n.disp,fa),u=bt(n.each,f=>{}),{fill:d,stroke:h}=c;return(f,m,v,g)=>Er(f,m,(p,S,C,b,E,T,D,y,A,F,L)=>{let U=p.pxRound,G=t,q=i*At,O=a*At,Y=l*At,H,ie;b.ori==0?[H,ie]=r(f,m):[ie,H]=r(f,m);let oe=b.dir*(b.ori==0?1:-1),le=b.ori==0?kl:pd,de=b.ori==0?u:(fe,R,x,X,K,ee,me)=>{u(fe,R,x,K,X,me,ee)},ue=bt(f.bands,ad).find(fe=>fe.series[0]==m),_e=ue!=null?ue.dir:0,st=p.fillTo(f,m,p.min,p.max,_e),Qe=U(D(st,E,L,A)),Q,ae,he,Ve=F,De=U(p.width*At),Be=!1,St=null,$e=null,ft=null,ct=null;d!=null&&(De==0||h!=null)&&(Be=!0,St=d.values(f,m,v,g),$e=new Map,new Set(St).forEach(fe=>{fe!=null&&$e.set(fe,new Path2D)}),De>0&&(ft=h.values(f,m,v,g),ct=new Map,new Set(ft).forEach(fe=>{fe!=null&&ct.set(fe,new Path2D)})));let{x0:ot,size:Xt}=c;if(ot!=null&&Xt!=null){G=1,S=ot.values(f,m,v,g),ot.unit==2&&(S=S.map(x=>f.posToVal(y+x*F,b.key,!0)));let fe=Xt.values(f,m,v,g);Xt.unit==2?ae=fe[0]*F:ae=T(fe[0],b,F,y)-T(0,b,F,y),Ve=pm(S,C,T,b,F,y,Ve),he=Ve-ae+q}else Ve=pm(S,C,T,b,F,y,Ve),he=Ve*o+q,ae=Ve-he;he<1&&(he=0),De>=ae/2&&(De=0),he<5&&(U=Sm);let Qt=he>0,qt=Ve-he-(Qt?De:0);ae=U(Zh(qt,Y,O)),Q=(G==0?ae/2:G==oe?0:ae)-G*oe*((G==0?q/2:0)+(Qt?De/2:0));let vt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Lt=Be?null:new Path2D,Ct=null;if(ue!=null)Ct=f.data[ue.series[1]];else{let{y0:fe,y1:R}=c;fe!=null&&R!=null&&(C=R.values(f,m,v,g),Ct=fe.values(f,m,v,g))}let V=H*ae,We=ie*ae;for(let fe=oe==1?v:g;fe>=v&&fe<=g;fe+=oe){let R=C[fe];if(R==null)continue;if(Ct!=null){let ne=Ct[fe]??0;if(R-ne==0)continue;Qe=D(ne,E,L,A)}let x=b.distr!=2||c!=null?S[fe]:fe,X=T(x,b,F,y),K=D(bt(R,st),E,L,A),ee=U(X-Q),me=U(Qn(K,Qe)),ge=U(Gi(K,Qe)),te=me-ge;if(R!=null){let ne=R<0?We:V,xe=R<0?V:We;Be?(De>0&&ft[fe]!=null&&le(ct.get(ft[fe]),ee,ge+gi(De/2),ae,Qn(0,te-De),ne,xe),St[fe]!=null&&le($e.get(St[fe]),ee,ge+gi(De/2),ae,Qn(0,te-De),ne,xe)):le(Lt,ee,ge+gi(De/2),ae,Qn(0,te-De),ne,xe),de(f,m,fe,ee-De/2,ge,ae+De,te)}}return De>0?vt.stroke=Be?ct:Lt:Be||(vt._fill=p.width==0?p._fill:p._stroke??p._fill,vt.width=0),vt.fill=Be?$e:Lt,vt})}function Ky(n,e){let t=bt(e?.alignGaps,0);return(i,s,r,o)=>Er(i,s,(a,l,c,u,d,h,f,m,v,g,p)=>{[r,o]=Ll(c,r,o);let S=a.pxRound,C=H=>S(h(H,u,g,m)),b=H=>S(f(H,d,p,v)),E,T,D;u.ori==0?(E=Ol,D=mo,T=Km):(E=Bl,D=go,T=Jm);let y=u.dir*(u.ori==0?1:-1),A=C(l[y==1?r:o]),F=A,L=[],U=[];for(let H=y==1?r:o;H>=r&&H<=o;H+=y)if(c[H]!=null){let oe=l[H],le=C(oe);L.push(F=le),U.push(b(c[H]))}let G={stroke:n(L,U,E,D,T,S),fill:null,clip:null,band:null,gaps:null,flags:fo},q=G.stroke,[O,Y]=dd(i,s);if(a.fill!=null||O!=0){let H=G.fill=new Path2D(q),ie=a.fillTo(i,s,a.min,a.max,O),oe=b(ie);D(H,F,oe),D(H,A,oe)}if(!a.spanGaps){let H=[];H.push(...fd(l,c,r,o,y,C,t)),G.gaps=H=a.gaps(i,s,r,o,H),G.clip=Ul(H,u.ori,m,v,g,p)}return Y!=0&&(G.band=Y==2?[_s(i,s,r,o,q,-1),_s(i,s,r,o,q,1)]:_s(i,s,r,o,q,Y)),G})}function Jy(n){return Ky(jy,n)}function jy(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),d=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],d[h]=n[h+1]-n[h],c[h]=u[h]/d[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(d[h-1]+d[h])/((2*d[h]+d[h-1])/c[h-1]+(d[h]+2*d[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+d[h]/3,e[h]+l[h]*d[h]/3,n[h+1]-d[h]/3,e[h+1]-l[h+1]*d[h]/3,n[h+1],e[h+1])}return a}var Qh=new Set;function mm(){for(let n of Qh)n.syncRect(!0)}po&&(wr(Lv,lo,mm),wr(Nv,lo,mm,!0),wr(Rl,lo,()=>{wn.pxRatio=At}));var Qy=eg(),eb=jm();function gm(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>ed(r,o,e,t))}function tb(n,e){return n.map((t,i)=>i==0?{}:_n({},e,t))}function ed(n,e,t,i){return _n({},e==0?t:i,n)}function tg(n,e,t){return e==null?uo:[e,t]}var nb=tg;function ib(n,e,t){return e==null?uo:Pl(e,t,rd,!0)}function ng(n,e,t,i){return e==null?uo:Nl(e,t,n.scales[i].log,!1)}var sb=ng;function ig(n,e,t,i){return e==null?uo:sd(e,t,n.scales[i].log,!1)}var rb=ig;function ob(n,e,t,i,s){let r=Qn($p(n),$p(e)),o=e-n,a=zi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?zs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function _m(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Mn((t=+s)*At))+"px"),[n,e,t]}function ab(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Wt(e[2]*At,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function wn(n,e,t){let i={mode:bt(n.mode,1)},s=i.mode;function r(_,M,P,N){let B=M.valToPct(_);return N+P*(M.dir==-1?1-B:B)}function o(_,M,P,N){let B=M.valToPct(_);return N+P*(M.dir==-1?B:1-B)}function a(_,M,P,N){return M.ori==0?r(_,M,P,N):o(_,M,P,N)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ri(pv);if(n.id!=null&&(c.id=n.id),mi(c,n.class),n.title){let _=Ri(_v,c);_.textContent=n.title}let u=Vi("canvas"),d=i.ctx=u.getContext("2d"),h=Ri(xv,c);wr("click",h,_=>{_.target===m&&(Yt!=Jr||tn!=jr)&&On.click(i,_)},!0);let f=i.under=Ri(vv,h);h.appendChild(u);let m=i.over=Ri(yv,h);n=ho(n);let v=+bt(n.pxAlign,1),g=fm(v);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});let p=n.ms||.001,S=i.series=s==1?gm(n.series||[],om,hm,!1):tb(n.series||[null],um),C=i.axes=gm(n.axes||[],rm,lm,!0),b=i.scales={},E=i.bands=n.bands||[];E.forEach(_=>{_.fill=gt(_.fill||null),_.dir=bt(_.dir,-1)});let T=s==2?S[1].facets[0].scale:S[0].scale,D={axes:Bt,series:Nt},y=(n.drawOrder||["axes","series"]).map(_=>D[_]);function A(_){let M=_.distr==3?P=>gs(P>0?P:_.clamp(i,P,_.min,_.max,_.key)):_.distr==4?P=>zh(P,_.asinh):_.distr==100?P=>_.fwd(P):P=>P;return P=>{let N=M(P),{_min:B,_max:Z}=_,re=Z-B;return(N-B)/re}}function F(_){let M=b[_];if(M==null){let P=(n.scales||fa)[_]||fa;if(P.from!=null){F(P.from);let N=_n({},b[P.from],P,{key:_});N.valToPct=A(N),b[_]=N}else{M=b[_]=_n({},_==T?Xm:Hy,P),M.key=_;let N=M.time,B=M.range,Z=Vs(B);if((_!=T||s==2&&!N)&&(Z&&(B[0]==null||B[1]==null)&&(B={min:B[0]==null?Xp:{mode:1,hard:B[0],soft:B[0]},max:B[1]==null?Xp:{mode:1,hard:B[1],soft:B[1]}},Z=!1),!Z&&Fl(B))){let re=B;B=(pe,ve,Re)=>ve==null?uo:Pl(ve,Re,re)}M.range=gt(B||(N?nb:_==T?M.distr==3?sb:M.distr==4?rb:tg:M.distr==3?ng:M.distr==4?ig:ib)),M.auto=gt(Z?!1:M.auto),M.clamp=gt(M.clamp||Gy),M._min=M._max=null,M.valToPct=A(M)}}}F("x"),F("y"),s==1&&S.forEach(_=>{F(_.scale)}),C.forEach(_=>{F(_.scale)});for(let _ in n.scales)F(_);let L=b[T],U=L.distr,G,q;L.ori==0?(mi(c,mv),G=r,q=o):(mi(c,gv),G=o,q=r);let O={};for(let _ in b){let M=b[_];(M.min!=null||M.max!=null)&&(O[_]={min:M.min,max:M.max},M.min=M.max=null)}let Y=n.tzDate||(_=>new Date(Mn(_/p))),H=n.fmtDate||ld,ie=p==1?my(Y):xy(Y),oe=nm(Y,tm(p==1?py:_y,H)),le=sm(Y,im(yy,H)),de=[],ue=i.legend=_n({},Sy,n.legend),_e=i.cursor=_n({},Ry,{drag:{y:s==2}},n.cursor),st=ue.show,Qe=_e.show,Q=ue.markers;ue.idxs=de,Q.width=gt(Q.width),Q.dash=gt(Q.dash),Q.stroke=gt(Q.stroke),Q.fill=gt(Q.fill);let ae,he,Ve,De=[],Be=[],St,$e=!1,ft={};if(ue.live){let _=S[1]?S[1].values:null;$e=_!=null,St=$e?_(i,1,0):{_:0};for(let M in St)ft[M]=nd}if(st)if(ae=Vi("table",Ev,c),Ve=Vi("tbody",null,ae),ue.mount(i,ae),$e){he=Vi("thead",null,ae,Ve);let _=Vi("tr",null,he);Vi("th",null,_);for(var ct in St)Vi("th",Lp,_).textContent=ct}else mi(ae,Cv),ue.live&&mi(ae,Av);let ot={show:!0},Xt={show:!1};function Qt(_,M){if(M==0&&($e||!ue.live||s==2))return uo;let P=[],N=Vi("tr",Rv,Ve,Ve.childNodes[M]);mi(N,_.class),_.show||mi(N,Sr);let B=Vi("th",null,N);if(Q.show){let pe=Ri(Pv,B);if(M>0){let ve=Q.width(i,M);ve&&(pe.style.border=ve+"px "+Q.dash(i,M)+" "+Q.stroke(i,M)),pe.style.background=Q.fill(i,M)}}let Z=Ri(Lp,B);_.label instanceof HTMLElement?Z.appendChild(_.label):Z.textContent=_.label,M>0&&(Q.show||(Z.style.color=_.width>0?Q.stroke(i,M):Q.fill(i,M)),vt("click",B,pe=>{if(_e._lock)return;Ne(pe);let ve=S.indexOf(_);if((pe.ctrlKey||pe.metaKey)!=ue.isolate){let Re=S.some((Le,Fe)=>Fe>0&&Fe!=ve&&Le.show);S.forEach((Le,Fe)=>{Fe>0&&Qi(Fe,Re?Fe==ve?ot:Xt:ot,!0,gn.setSeries)})}else Qi(ve,{show:!_.show},!0,gn.setSeries)},!1),Fn&&vt(Up,B,pe=>{_e._lock||(Ne(pe),Qi(S.indexOf(_),eo,!0,gn.setSeries))},!1));for(var re in St){let pe=Vi("td",Iv,N);pe.textContent="--",P.push(pe)}return[N,P]}let qt=new Map;function vt(_,M,P,N=!0){let B=qt.get(M)||{},Z=_e.bind[_](i,M,P,N);Z&&(wr(_,M,B[_]=Z),qt.set(M,B))}function Lt(_,M,P){let N=qt.get(M)||{};for(let B in N)(_==null||B==_)&&($h(B,M,N[B]),delete N[B]);_==null&&qt.delete(M)}let Ct=0,V=0,We=0,fe=0,R=0,x=0,X=R,K=x,ee=We,me=fe,ge=0,te=0,ne=0,xe=0;i.bbox={};let ke=!1,Me=!1,ye=!1,Oe=!1,Xe=!1,qe=!1;function k(_,M,P){(P||_!=i.width||M!=i.height)&&be(_,M),$n(!1),ye=!0,Me=!0,$r()}function be(_,M){i.width=Ct=We=_,i.height=V=fe=M,R=x=0,ce(),ze();let P=i.bbox;ge=P.left=br(R*At,.5),te=P.top=br(x*At,.5),ne=P.width=br(We*At,.5),xe=P.height=br(fe*At,.5)}let se=3;function Se(){let _=!1,M=0;for(;!_;){M++;let P=on(M),N=ji(M);_=M==se||P&&N,_||(be(i.width,i.height),Me=!0)}}function Ae({width:_,height:M}){k(_,M)}i.setSize=Ae;function ce(){let _=!1,M=!1,P=!1,N=!1;C.forEach((B,Z)=>{if(B.show&&B._show){let{side:re,_size:pe}=B,ve=re%2,Re=B.label!=null?B.labelSize:0,Le=pe+Re;Le>0&&(ve?(We-=Le,re==3?(R+=Le,N=!0):P=!0):(fe-=Le,re==0?(x+=Le,_=!0):M=!0))}}),Xn[0]=_,Xn[1]=P,Xn[2]=M,Xn[3]=N,We-=ci[1]+ci[3],R+=ci[3],fe-=ci[2]+ci[0],x+=ci[0]}function ze(){let _=R+We,M=x+fe,P=R,N=x;function B(Z,re){switch(Z){case 1:return _+=re,_-re;case 2:return M+=re,M-re;case 3:return P-=re,P+re;case 0:return N-=re,N+re}}C.forEach((Z,re)=>{if(Z.show&&Z._show){let pe=Z.side;Z._pos=B(pe,Z._size),Z.label!=null&&(Z._lpos=B(pe,Z.labelSize))}})}if(_e.dataIdx==null){let _=_e.hover,M=_.skip=new Set(_.skip??[]);M.add(void 0);let P=_.prox=gt(_.prox),N=_.bias??=0;_e.dataIdx=(B,Z,re,pe)=>{if(Z==0)return re;let ve=re,Re=P(B,Z,re,pe)??Ht,Le=Re>=0&&Re<Ht,Fe=L.ori==0?We:fe,tt=_e.left,Et=e[0],yt=e[Z];if(M.has(yt[re])){ve=null;let dt=null,Ze=null,He;if(N==0||N==-1)for(He=re;dt==null&&He-- >0;)M.has(yt[He])||(dt=He);if(N==0||N==1)for(He=re;Ze==null&&He++<yt.length;)M.has(yt[He])||(Ze=He);if(dt!=null||Ze!=null)if(Le){let Zt=dt==null?-1/0:G(Et[dt],L,Fe,0),ln=Ze==null?1/0:G(Et[Ze],L,Fe,0),Nn=tt-Zt,kt=ln-tt;Nn<=kt?Nn<=Re&&(ve=dt):kt<=Re&&(ve=Ze)}else ve=Ze==null?dt:dt==null?Ze:re-dt<=Ze-re?dt:Ze}else Le&&Sn(tt-G(Et[re],L,Fe,0))>Re&&(ve=null);return ve}}let Ne=_=>{_e.event=_};_e.idxs=de,_e._lock=!1;let lt=_e.points;lt.show=gt(lt.show),lt.size=gt(lt.size),lt.stroke=gt(lt.stroke),lt.width=gt(lt.width),lt.fill=gt(lt.fill);let ht=i.focus=_n({},n.focus||{alpha:.3},_e.focus),Fn=ht.prox>=0,Un=Fn&&lt.one,ii=[],Is=[],ps=[];function qr(_,M){let P=lt.show(i,M);if(P instanceof HTMLElement)return mi(P,Tv),mi(P,_.class),is(P,-10,-10,We,fe),m.insertBefore(P,ii[M]),P}function pl(_,M){if(s==1||M>0){let P=s==1&&b[_.scale].time,N=_.value;_.value=P?Jp(N)?sm(Y,im(N,H)):N||le:N||ky,_.label=_.label||(P?Iy:Py)}if(Un||M>0){_.width=_.width==null?1:_.width,_.paths=_.paths||Qy||Hv,_.fillTo=gt(_.fillTo||Wy),_.pxAlign=+bt(_.pxAlign,v),_.pxRound=fm(_.pxAlign),_.stroke=gt(_.stroke||null),_.fill=gt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let P=Vy(Qn(1,_.width),1),N=_.points=_n({},{size:P,width:Qn(1,P*.2),stroke:_.stroke,space:P*2,paths:eb,_stroke:null,_fill:null},_.points);N.show=gt(N.show),N.filter=gt(N.filter),N.fill=gt(N.fill),N.stroke=gt(N.stroke),N.paths=gt(N.paths),N.pxAlign=_.pxAlign}if(st){let P=Qt(_,M);De.splice(M,0,P[0]),Be.splice(M,0,P[1]),ue.values.push(null)}if(Qe){de.splice(M,0,null);let P=null;Un?M==0&&(P=qr(_,M)):M>0&&(P=qr(_,M)),ii.splice(M,0,P),Is.splice(M,0,0),ps.splice(M,0,0)}Ln("addSeries",M)}function ml(_,M){M=M??S.length,_=s==1?ed(_,M,om,hm):ed(_,M,{},um),S.splice(M,0,_),pl(S[M],M)}i.addSeries=ml;function gl(_){if(S.splice(_,1),st){ue.values.splice(_,1),Be.splice(_,1);let M=De.splice(_,1)[0];Lt(null,M.firstChild),M.remove()}Qe&&(de.splice(_,1),ii.splice(_,1)[0].remove(),Is.splice(_,1),ps.splice(_,1)),Ln("delSeries",_)}i.delSeries=gl;let Xn=[!1,!1,!1,!1];function Qo(_,M){if(_._show=_.show,_.show){let P=_.side%2,N=b[_.scale];N==null&&(_.scale=P?S[1].scale:T,N=b[_.scale]);let B=N.time;_.size=gt(_.size),_.space=gt(_.space),_.rotate=gt(_.rotate),Vs(_.incrs)&&_.incrs.forEach(re=>{!zs.has(re)&&zs.set(re,Em(re))}),_.incrs=gt(_.incrs||(N.distr==2?hy:B?p==1?fy:gy:Mr)),_.splits=gt(_.splits||(B&&N.distr==1?ie:N.distr==3?Kh:N.distr==4?Dy:Ny)),_.stroke=gt(_.stroke),_.grid.stroke=gt(_.grid.stroke),_.ticks.stroke=gt(_.ticks.stroke),_.border.stroke=gt(_.border.stroke);let Z=_.values;_.values=Vs(Z)&&!Vs(Z[0])?gt(Z):B?Vs(Z)?nm(Y,tm(Z,H)):Jp(Z)?vy(Y,Z):Z||oe:Z||Ly,_.filter=gt(_.filter||(N.distr>=3&&N.log==10?Oy:N.distr==3&&N.log==2?By:wm)),_.font=_m(_.font),_.labelFont=_m(_.labelFont),_._size=_.size(i,null,M,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Xn[M]=!0,_._el=Ri(bv,h))}}function Ls(_,M,P,N){let[B,Z,re,pe]=P,ve=M%2,Re=0;return ve==0&&(pe||Z)&&(Re=M==0&&!B||M==2&&!re?Mn(rm.size/3):0),ve==1&&(B||re)&&(Re=M==1&&!Z||M==3&&!pe?Mn(lm.size/2):0),Re}let ea=i.padding=(n.padding||[Ls,Ls,Ls,Ls]).map(_=>gt(bt(_,Ls))),ci=i._padding=ea.map((_,M)=>_(i,M,Xn,0)),mn,sn=null,fn=null,pr=s==1?S[0].idxs:null,ui=null,mr=!1;function _l(_,M){if(e=_??[],i.data=i._data=e,s==2){mn=0;for(let P=1;P<S.length;P++)mn+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),ui=e[0],mn=ui.length;let P=e;if(U==2){P=e.slice();let N=P[0]=Array(mn);for(let B=0;B<mn;B++)N[B]=B}i._data=e=P}if($n(!0),Ln("setData"),U==2&&(ye=!0),M!==!1){let P=L;P.auto(i,mr)?ta():Fs(T,P.min,P.max),Oe=Oe||_e.left>=0,qe=!0,$r()}}i.setData=_l;function ta(){mr=!0;let _,M;s==1&&(mn>0?(sn=pr[0]=0,fn=pr[1]=mn-1,_=e[0][sn],M=e[0][fn],U==2?(_=sn,M=fn):_==M&&(U==3?[_,M]=Nl(_,_,L.log,!1):U==4?[_,M]=sd(_,_,L.log,!1):L.time?M=_+Mn(86400/p):[_,M]=Pl(_,M,rd,!0))):(sn=pr[0]=_=null,fn=pr[1]=M=null)),Fs(T,_,M)}let w,W,j,$,J,Te,Pe,we,Ue,Ce;function et(_,M,P,N,B,Z){_??=Dp,P??=ad,N??="butt",B??=Dp,Z??="round",_!=w&&(d.strokeStyle=w=_),B!=W&&(d.fillStyle=W=B),M!=j&&(d.lineWidth=j=M),Z!=J&&(d.lineJoin=J=Z),N!=Te&&(d.lineCap=Te=N),P!=$&&d.setLineDash($=P)}function rt(_,M,P,N){M!=W&&(d.fillStyle=W=M),_!=Pe&&(d.font=Pe=_),P!=we&&(d.textAlign=we=P),N!=Ue&&(d.textBaseline=Ue=N)}function Ge(_,M,P,N,B=0){if(N.length>0&&_.auto(i,mr)&&(M==null||M.min==null)){let Z=bt(sn,0),re=bt(fn,N.length-1),pe=P.min==null?Ov(N,Z,re,B,_.distr==3):[P.min,P.max];_.min=Gi(_.min,P.min=pe[0]),_.max=Qn(_.max,P.max=pe[1])}}let wt={min:null,max:null};function rn(){for(let N in b){let B=b[N];O[N]==null&&(B.min==null||O[T]!=null&&B.auto(i,mr))&&(O[N]=wt)}for(let N in b){let B=b[N];O[N]==null&&B.from!=null&&O[B.from]!=null&&(O[N]=wt)}O[T]!=null&&$n(!0);let _={};for(let N in O){let B=O[N];if(B!=null){let Z=_[N]=ho(b[N],qv);if(B.min!=null)_n(Z,B);else if(N!=T||s==2)if(mn==0&&Z.from==null){let re=Z.range(i,null,null,N);Z.min=re[0],Z.max=re[1]}else Z.min=Ht,Z.max=-Ht}}if(mn>0){S.forEach((N,B)=>{if(s==1){let Z=N.scale,re=O[Z];if(re==null)return;let pe=_[Z];if(B==0){let ve=pe.range(i,pe.min,pe.max,Z);pe.min=ve[0],pe.max=ve[1],sn=zi(pe.min,e[0]),fn=zi(pe.max,e[0]),fn-sn>1&&(e[0][sn]<pe.min&&sn++,e[0][fn]>pe.max&&fn--),N.min=ui[sn],N.max=ui[fn]}else N.show&&N.auto&&Ge(pe,re,N,e[B],N.sorted);N.idxs[0]=sn,N.idxs[1]=fn}else if(B>0&&N.show&&N.auto){let[Z,re]=N.facets,pe=Z.scale,ve=re.scale,[Re,Le]=e[B],Fe=_[pe],tt=_[ve];Fe!=null&&Ge(Fe,O[pe],Z,Re,Z.sorted),tt!=null&&Ge(tt,O[ve],re,Le,re.sorted),N.min=re.min,N.max=re.max}});for(let N in _){let B=_[N],Z=O[N];if(B.from==null&&(Z==null||Z.min==null)){let re=B.range(i,B.min==Ht?null:B.min,B.max==-Ht?null:B.max,N);B.min=re[0],B.max=re[1]}}}for(let N in _){let B=_[N];if(B.from!=null){let Z=_[B.from];if(Z.min==null)B.min=B.max=null;else{let re=B.range(i,Z.min,Z.max,N);B.min=re[0],B.max=re[1]}}}let M={},P=!1;for(let N in _){let B=_[N],Z=b[N];if(Z.min!=B.min||Z.max!=B.max){Z.min=B.min,Z.max=B.max;let re=Z.distr;Z._min=re==3?gs(Z.min):re==4?zh(Z.min,Z.asinh):re==100?Z.fwd(Z.min):Z.min,Z._max=re==3?gs(Z.max):re==4?zh(Z.max,Z.asinh):re==100?Z.fwd(Z.max):Z.max,M[N]=P=!0}}if(P){S.forEach((N,B)=>{s==2?B>0&&M.y&&(N._paths=null):M[N.scale]&&(N._paths=null)});for(let N in M)ye=!0,Ln("setScale",N);Qe&&_e.left>=0&&(Oe=qe=!0)}for(let N in O)O[N]=null}function en(_){let M=Zh(sn-1,0,mn-1),P=Zh(fn+1,0,mn-1);for(;_[M]==null&&M>0;)M--;for(;_[P]==null&&P<mn-1;)P++;return[M,P]}function Nt(){if(mn>0){let _=S.some(M=>M._focus)&&Ce!=ht.alpha;_&&(d.globalAlpha=Ce=ht.alpha),S.forEach((M,P)=>{if(P>0&&M.show&&(bn(P,!1),bn(P,!0),M._paths==null)){let N=Ce;Ce!=M.alpha&&(d.globalAlpha=Ce=M.alpha);let B=s==2?[0,e[P][0].length-1]:en(e[P]);M._paths=M.paths(i,P,B[0],B[1]),Ce!=N&&(d.globalAlpha=Ce=N)}}),S.forEach((M,P)=>{if(P>0&&M.show){let N=Ce;Ce!=M.alpha&&(d.globalAlpha=Ce=M.alpha),M._paths!=null&&Ie(P,!1);{let B=M._paths!=null?M._paths.gaps:null,Z=M.points.show(i,P,sn,fn,B),re=M.points.filter(i,P,Z,B);(Z||re)&&(M.points._paths=M.points.paths(i,P,sn,fn,re),Ie(P,!0))}Ce!=N&&(d.globalAlpha=Ce=N),Ln("drawSeries",P)}}),_&&(d.globalAlpha=Ce=1)}}function bn(_,M){let P=M?S[_].points:S[_];P._stroke=P.stroke(i,_),P._fill=P.fill(i,_)}function Ie(_,M){let P=M?S[_].points:S[_],{stroke:N,fill:B,clip:Z,flags:re,_stroke:pe=P._stroke,_fill:ve=P._fill,_width:Re=P.width}=P._paths;Re=Wt(Re*At,3);let Le=null,Fe=Re%2/2;M&&ve==null&&(ve=Re>0?"#fff":pe);let tt=P.pxAlign==1&&Fe>0;if(tt&&d.translate(Fe,Fe),!M){let Et=ge-Re/2,yt=te-Re/2,dt=ne+Re,Ze=xe+Re;Le=new Path2D,Le.rect(Et,yt,dt,Ze)}M?Bn(pe,Re,P.dash,P.cap,ve,N,B,re,Z):qn(_,pe,Re,P.dash,P.cap,ve,N,B,re,Le,Z),tt&&d.translate(-Fe,-Fe)}function qn(_,M,P,N,B,Z,re,pe,ve,Re,Le){let Fe=!1;ve!=0&&E.forEach((tt,Et)=>{if(tt.series[0]==_){let yt=S[tt.series[1]],dt=e[tt.series[1]],Ze=(yt._paths||fa).band;Vs(Ze)&&(Ze=tt.dir==1?Ze[0]:Ze[1]);let He,Zt=null;yt.show&&Ze&&kv(dt,sn,fn)?(Zt=tt.fill(i,Et)||Z,He=yt._paths.clip):Ze=null,Bn(M,P,N,B,Zt,re,pe,ve,Re,Le,He,Ze),Fe=!0}}),Fe||Bn(M,P,N,B,Z,re,pe,ve,Re,Le)}let pt=fo|jh;function Bn(_,M,P,N,B,Z,re,pe,ve,Re,Le,Fe){et(_,M,P,N,B),(ve||Re||Fe)&&(d.save(),ve&&d.clip(ve),Re&&d.clip(Re)),Fe?(pe&pt)==pt?(d.clip(Fe),Le&&d.clip(Le),hi(B,re),Yn(_,Z,M)):pe&jh?(hi(B,re),d.clip(Fe),Yn(_,Z,M)):pe&fo&&(d.save(),d.clip(Fe),Le&&d.clip(Le),hi(B,re),d.restore(),Yn(_,Z,M)):(hi(B,re),Yn(_,Z,M)),(ve||Re||Fe)&&d.restore()}function Yn(_,M,P){P>0&&(M instanceof Map?M.forEach((N,B)=>{d.strokeStyle=w=B,d.stroke(N)}):M!=null&&_&&d.stroke(M))}function hi(_,M){M instanceof Map?M.forEach((P,N)=>{d.fillStyle=W=N,d.fill(P)}):M!=null&&_&&d.fill(M)}function Ns(_,M,P,N){let B=C[_],Z;if(N<=0)Z=[0,0];else{let re=B._space=B.space(i,_,M,P,N),pe=B._incrs=B.incrs(i,_,M,P,N,re);Z=ob(M,P,pe,N,re)}return B._found=Z}function Tt(_,M,P,N,B,Z,re,pe,ve,Re){let Le=re%2/2;v==1&&d.translate(Le,Le),et(pe,re,ve,Re,pe),d.beginPath();let Fe,tt,Et,yt,dt=B+(N==0||N==3?-Z:Z);P==0?(tt=B,yt=dt):(Fe=B,Et=dt);for(let Ze=0;Ze<_.length;Ze++)M[Ze]!=null&&(P==0?Fe=Et=_[Ze]:tt=yt=_[Ze],d.moveTo(Fe,tt),d.lineTo(Et,yt));d.stroke(),v==1&&d.translate(-Le,-Le)}function on(_){let M=!0;return C.forEach((P,N)=>{if(!P.show)return;let B=b[P.scale];if(B.min==null){P._show&&(M=!1,P._show=!1,$n(!1));return}else P._show||(M=!1,P._show=!0,$n(!1));let Z=P.side,re=Z%2,{min:pe,max:ve}=B,[Re,Le]=Ns(N,pe,ve,re==0?We:fe);if(Le==0)return;let Fe=B.distr==2,tt=P._splits=P.splits(i,N,pe,ve,Re,Le,Fe),Et=B.distr==2?tt.map(He=>ui[He]):tt,yt=B.distr==2?ui[tt[1]]-ui[tt[0]]:Re,dt=P._values=P.values(i,P.filter(i,Et,N,Le,yt),N,Le,yt);P._rotate=Z==2?P.rotate(i,dt,N,Le):0;let Ze=P._size;P._size=Pi(P.size(i,dt,N,_)),Ze!=null&&P._size!=Ze&&(M=!1)}),M}function ji(_){let M=!0;return ea.forEach((P,N)=>{let B=P(i,N,Xn,_);B!=ci[N]&&(M=!1),ci[N]=B}),M}function Bt(){for(let _=0;_<C.length;_++){let M=C[_];if(!M.show||!M._show)continue;let P=M.side,N=P%2,B,Z,re=M.stroke(i,_),pe=P==0||P==3?-1:1,[ve,Re]=M._found;if(M.label!=null){let Kn=M.labelGap*pe,pi=Mn((M._lpos+Kn)*At);rt(M.labelFont[0],re,"center",P==2?"top":Np),d.save(),N==1?(B=Z=0,d.translate(pi,Mn(te+xe/2)),d.rotate((P==3?-Cl:Cl)/2)):(B=Mn(ge+ne/2),Z=pi);let xr=Mm(M.label)?M.label(i,_,ve,Re):M.label;d.fillText(xr,B,Z),d.restore()}if(Re==0)continue;let Le=b[M.scale],Fe=N==0?ne:xe,tt=N==0?ge:te,Et=M._splits,yt=Le.distr==2?Et.map(Kn=>ui[Kn]):Et,dt=Le.distr==2?ui[Et[1]]-ui[Et[0]]:ve,Ze=M.ticks,He=M.border,Zt=Ze.show?Ze.size:0,ln=Mn(Zt*At),Nn=Mn((M.alignTo==2?M._size-Zt-M.gap:M.gap)*At),kt=M._rotate*-Cl/180,cn=g(M._pos*At),di=(ln+Nn)*pe,Zn=cn+di;Z=N==0?Zn:0,B=N==1?Zn:0;let Ai=M.font[0],Oi=M.align==1?oo:M.align==2?Bh:kt>0?oo:kt<0?Bh:N==0?"center":P==3?Bh:oo,ts=kt||N==1?"middle":P==2?"top":Np;rt(Ai,re,Oi,ts);let fi=M.font[1]*M.lineGap,Ci=Et.map(Kn=>g(a(Kn,Le,Fe,tt))),Bi=M._values;for(let Kn=0;Kn<Bi.length;Kn++){let pi=Bi[Kn];if(pi!=null){N==0?B=Ci[Kn]:Z=Ci[Kn],pi=""+pi;let xr=pi.indexOf(`
`)==-1?[pi]:pi.split(/\n/gm);for(let Jn=0;Jn<xr.length;Jn++){let Sp=xr[Jn];kt?(d.save(),d.translate(B,Z+Jn*fi),d.rotate(kt),d.fillText(Sp,0,0),d.restore()):d.fillText(Sp,B,Z+Jn*fi)}}}Ze.show&&Tt(Ci,Ze.filter(i,yt,_,Re,dt),N,P,cn,ln,Wt(Ze.width*At,3),Ze.stroke(i,_),Ze.dash,Ze.cap);let ns=M.grid;ns.show&&Tt(Ci,ns.filter(i,yt,_,Re,dt),N,N==0?2:1,N==0?te:ge,N==0?xe:ne,Wt(ns.width*At,3),ns.stroke(i,_),ns.dash,ns.cap),He.show&&Tt([cn],[1],N==0?1:0,N==0?1:2,N==1?te:ge,N==1?xe:ne,Wt(He.width*At,3),He.stroke(i,_),He.dash,He.cap)}Ln("drawAxes")}function $n(_){S.forEach((M,P)=>{P>0&&(M._paths=null,_&&(s==1?(M.min=null,M.max=null):M.facets.forEach(N=>{N.min=null,N.max=null})))})}let Ui=!1,Yr=!1,na=[];function Xx(){Yr=!1;for(let _=0;_<na.length;_++)Ln(...na[_]);na.length=0}function $r(){Ui||(Qv(rp),Ui=!0)}function qx(_,M=!1){Ui=!0,Yr=M,_(i),rp(),M&&na.length>0&&queueMicrotask(Xx)}i.batch=qx;function rp(){if(ke&&(rn(),ke=!1),ye&&(Se(),ye=!1),Me){if(Kt(f,oo,R),Kt(f,"top",x),Kt(f,ca,We),Kt(f,ua,fe),Kt(m,oo,R),Kt(m,"top",x),Kt(m,ca,We),Kt(m,ua,fe),Kt(h,ca,Ct),Kt(h,ua,V),u.width=Mn(Ct*At),u.height=Mn(V*At),C.forEach(({_el:_,_show:M,_size:P,_pos:N,side:B})=>{if(_!=null)if(M){let Z=B===3||B===0?P:0,re=B%2==1;Kt(_,re?"left":"top",N-Z),Kt(_,re?"width":"height",P),Kt(_,re?"top":"left",re?x:R),Kt(_,re?"height":"width",re?fe:We),Yh(_,Sr)}else mi(_,Sr)}),w=W=j=J=Te=Pe=we=Ue=$=null,Ce=1,ra(!0),R!=X||x!=K||We!=ee||fe!=me){$n(!1);let _=We/ee,M=fe/me;if(Qe&&!Oe&&_e.left>=0){_e.left*=_,_e.top*=M,Zr&&is(Zr,Mn(_e.left),0,We,fe),Kr&&is(Kr,0,Mn(_e.top),We,fe);for(let P=0;P<ii.length;P++){let N=ii[P];N!=null&&(Is[P]*=_,ps[P]*=M,is(N,Pi(Is[P]),Pi(ps[P]),We,fe))}}if($t.show&&!Xe&&$t.left>=0&&$t.width>0){$t.left*=_,$t.width*=_,$t.top*=M,$t.height*=M;for(let P in Ph)Kt(Qr,P,$t[P])}X=R,K=x,ee=We,me=fe}Ln("setSize"),Me=!1}Ct>0&&V>0&&(d.clearRect(0,0,u.width,u.height),Ln("drawClear"),y.forEach(_=>_()),Ln("draw")),$t.show&&Xe&&(xl($t),Xe=!1),Qe&&Oe&&(_r(null,!0,!1),Oe=!1),ue.show&&ue.live&&qe&&(Ch(),qe=!1),l||(l=!0,i.status=1,Ln("ready")),mr=!1,Ui=!1}i.redraw=(_,M)=>{ye=M||!1,_!==!1?Fs(T,L.min,L.max):$r()};function Th(_,M){let P=b[_];if(P.from==null){if(mn==0){let N=P.range(i,M.min,M.max,_);M.min=N[0],M.max=N[1]}if(M.min>M.max){let N=M.min;M.min=M.max,M.max=N}if(mn>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;_==T&&P.distr==2&&mn>0&&(M.min=zi(M.min,e[0]),M.max=zi(M.max,e[0]),M.min==M.max&&M.max++),O[_]=M,ke=!0,$r()}}i.setScale=Th;let Eh,Ah,Zr,Kr,op,ap,Jr,jr,lp,cp,Yt,tn,Ds=!1,On=_e.drag,Pn=On.x,In=On.y;Qe&&(_e.x&&(Eh=Ri(Sv,m)),_e.y&&(Ah=Ri(wv,m)),L.ori==0?(Zr=Eh,Kr=Ah):(Zr=Ah,Kr=Eh),Yt=_e.left,tn=_e.top);let $t=i.select=_n({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Qr=$t.show?Ri(Mv,$t.over?m:f):null;function xl(_,M){if($t.show){for(let P in _)$t[P]=_[P],P in Ph&&Kt(Qr,P,_[P]);M!==!1&&Ln("setSelect")}}i.setSelect=xl;function Yx(_){if(S[_].show)st&&Yh(De[_],Sr);else if(st&&mi(De[_],Sr),Qe){let P=Un?ii[0]:ii[_];P!=null&&is(P,-10,-10,We,fe)}}function Fs(_,M,P){Th(_,{min:M,max:P})}function Qi(_,M,P,N){M.focus!=null&&jx(_),M.show!=null&&S.forEach((B,Z)=>{Z>0&&(_==Z||_==null)&&(B.show=M.show,Yx(Z),s==2?(Fs(B.facets[0].scale,null,null),Fs(B.facets[1].scale,null,null)):Fs(B.scale,null,null),$r())}),P!==!1&&Ln("setSeries",_,M),N&&oa("setSeries",i,_,M)}i.setSeries=Qi;function $x(_,M){_n(E[_],M)}function Zx(_,M){_.fill=gt(_.fill||null),_.dir=bt(_.dir,-1),M=M??E.length,E.splice(M,0,_)}function Kx(_){_==null?E.length=0:E.splice(_,1)}i.addBand=Zx,i.setBand=$x,i.delBand=Kx;function Jx(_,M){S[_].alpha=M,Qe&&ii[_]!=null&&(ii[_].style.opacity=M),st&&De[_]&&(De[_].style.opacity=M)}let ms,Us,gr,eo={focus:!0};function jx(_){if(_!=gr){let M=_==null,P=ht.alpha!=1;S.forEach((N,B)=>{if(s==1||B>0){let Z=M||B==0||B==_;N._focus=M?null:Z,P&&Jx(B,Z?1:ht.alpha)}}),gr=_,P&&$r()}}st&&Fn&&vt(Op,ae,_=>{_e._lock||(Ne(_),gr!=null&&Qi(null,eo,!0,gn.setSeries))});function es(_,M,P){let N=b[M];P&&(_=_/At-(N.ori==1?x:R));let B=We;N.ori==1&&(B=fe,_=B-_),N.dir==-1&&(_=B-_);let Z=N._min,re=N._max,pe=_/B,ve=Z+(re-Z)*pe,Re=N.distr;return Re==3?co(10,ve):Re==4?zv(ve,N.asinh):Re==100?N.bwd(ve):ve}function Qx(_,M){let P=es(_,T,M);return zi(P,e[0],sn,fn)}i.valToIdx=_=>zi(_,e[0]),i.posToIdx=Qx,i.posToVal=es,i.valToPos=(_,M,P)=>b[M].ori==0?r(_,b[M],P?ne:We,P?ge:0):o(_,b[M],P?xe:fe,P?te:0),i.setCursor=(_,M,P)=>{Yt=_.left,tn=_.top,_r(null,M,P)};function up(_,M){Kt(Qr,oo,$t.left=_),Kt(Qr,ca,$t.width=M)}function hp(_,M){Kt(Qr,"top",$t.top=_),Kt(Qr,ua,$t.height=M)}let ia=L.ori==0?up:hp,sa=L.ori==1?up:hp;function ev(){if(st&&ue.live)for(let _=s==2?1:0;_<S.length;_++){if(_==0&&$e)continue;let M=ue.values[_],P=0;for(let N in M)Be[_][P++].firstChild.nodeValue=M[N]}}function Ch(_,M){if(_!=null&&(_.idxs?_.idxs.forEach((P,N)=>{de[N]=P}):Xv(_.idx)||de.fill(_.idx),ue.idx=de[0]),st&&ue.live){for(let P=0;P<S.length;P++)(P>0||s==1&&!$e)&&tv(P,de[P]);ev()}qe=!1,M!==!1&&Ln("setLegend")}i.setLegend=Ch;function tv(_,M){let P=S[_],N=_==0&&U==2?ui:e[_],B;$e?B=P.values(i,_,M)??ft:(B=P.value(i,M==null?null:N[M],_,M),B=B==null?ft:{_:B}),ue.values[_]=B}function _r(_,M,P){lp=Yt,cp=tn,[Yt,tn]=_e.move(i,Yt,tn),_e.left=Yt,_e.top=tn,Qe&&(Zr&&is(Zr,Mn(Yt),0,We,fe),Kr&&is(Kr,0,Mn(tn),We,fe));let N,B=sn>fn;ms=Ht,Us=null;let Z=L.ori==0?We:fe,re=L.ori==1?We:fe;if(Yt<0||mn==0||B){N=_e.idx=null;for(let pe=0;pe<S.length;pe++){let ve=ii[pe];ve!=null&&is(ve,-10,-10,We,fe)}Fn&&Qi(null,eo,!0,_==null&&gn.setSeries),ue.live&&(de.fill(N),qe=!0)}else{let pe,ve,Re;s==1&&(pe=L.ori==0?Yt:tn,ve=es(pe,T),N=_e.idx=zi(ve,e[0],sn,fn),Re=G(e[0][N],L,Z,0));let Le=-10,Fe=-10,tt=0,Et=0,yt=!0,dt="",Ze="";for(let He=s==2?1:0;He<S.length;He++){let Zt=S[He],ln=de[He],Nn=ln==null?null:s==1?e[He][ln]:e[He][1][ln],kt=_e.dataIdx(i,He,N,ve),cn=kt==null?null:s==1?e[He][kt]:e[He][1][kt];if(qe=qe||cn!=Nn||kt!=ln,de[He]=kt,He>0&&Zt.show){let di=kt==null?-10:kt==N?Re:G(s==1?e[0][kt]:e[He][0][kt],L,Z,0),Zn=cn==null?-10:q(cn,s==1?b[Zt.scale]:b[Zt.facets[1].scale],re,0);if(Fn&&cn!=null){let Ai=L.ori==1?Yt:tn,Oi=Sn(ht.dist(i,He,kt,Zn,Ai));if(Oi<ms){let ts=ht.bias;if(ts!=0){let fi=es(Ai,Zt.scale),Ci=cn>=0?1:-1,Bi=fi>=0?1:-1;Bi==Ci&&(Bi==1?ts==1?cn>=fi:cn<=fi:ts==1?cn<=fi:cn>=fi)&&(ms=Oi,Us=He)}else ms=Oi,Us=He}}if(qe||Un){let Ai,Oi;L.ori==0?(Ai=di,Oi=Zn):(Ai=Zn,Oi=di);let ts,fi,Ci,Bi,ns,Kn,pi=!0,xr=lt.bbox;if(xr!=null){pi=!1;let Jn=xr(i,He);Ci=Jn.left,Bi=Jn.top,ts=Jn.width,fi=Jn.height}else Ci=Ai,Bi=Oi,ts=fi=lt.size(i,He);if(Kn=lt.fill(i,He),ns=lt.stroke(i,He),Un)He==Us&&ms<=ht.prox&&(Le=Ci,Fe=Bi,tt=ts,Et=fi,yt=pi,dt=Kn,Ze=ns);else{let Jn=ii[He];Jn!=null&&(Is[He]=Ci,ps[He]=Bi,Wp(Jn,ts,fi,pi),Gp(Jn,Kn,ns),is(Jn,Pi(Ci),Pi(Bi),We,fe))}}}}if(Un){let He=ht.prox,Zt=gr==null?ms<=He:ms>He||Us!=gr;if(qe||Zt){let ln=ii[0];ln!=null&&(Is[0]=Le,ps[0]=Fe,Wp(ln,tt,Et,yt),Gp(ln,dt,Ze),is(ln,Pi(Le),Pi(Fe),We,fe))}}}if($t.show&&Ds)if(_!=null){let[pe,ve]=gn.scales,[Re,Le]=gn.match,[Fe,tt]=_.cursor.sync.scales,Et=_.cursor.drag;if(Pn=Et._x,In=Et._y,Pn||In){let{left:yt,top:dt,width:Ze,height:He}=_.select,Zt=_.scales[Fe].ori,ln=_.posToVal,Nn,kt,cn,di,Zn,Ai=pe!=null&&Re(pe,Fe),Oi=ve!=null&&Le(ve,tt);Ai&&Pn?(Zt==0?(Nn=yt,kt=Ze):(Nn=dt,kt=He),cn=b[pe],di=G(ln(Nn,Fe),cn,Z,0),Zn=G(ln(Nn+kt,Fe),cn,Z,0),ia(Gi(di,Zn),Sn(Zn-di))):ia(0,Z),Oi&&In?(Zt==1?(Nn=yt,kt=Ze):(Nn=dt,kt=He),cn=b[ve],di=q(ln(Nn,tt),cn,re,0),Zn=q(ln(Nn+kt,tt),cn,re,0),sa(Gi(di,Zn),Sn(Zn-di))):sa(0,re)}else Ih()}else{let pe=Sn(lp-op),ve=Sn(cp-ap);if(L.ori==1){let tt=pe;pe=ve,ve=tt}Pn=On.x&&pe>=On.dist,In=On.y&&ve>=On.dist;let Re=On.uni;Re!=null?Pn&&In&&(Pn=pe>=Re,In=ve>=Re,!Pn&&!In&&(ve>pe?In=!0:Pn=!0)):On.x&&On.y&&(Pn||In)&&(Pn=In=!0);let Le,Fe;Pn&&(L.ori==0?(Le=Jr,Fe=Yt):(Le=jr,Fe=tn),ia(Gi(Le,Fe),Sn(Fe-Le)),In||sa(0,re)),In&&(L.ori==1?(Le=Jr,Fe=Yt):(Le=jr,Fe=tn),sa(Gi(Le,Fe),Sn(Fe-Le)),Pn||ia(0,Z)),!Pn&&!In&&(ia(0,0),sa(0,0))}if(On._x=Pn,On._y=In,_==null){if(P){if(Mp!=null){let[pe,ve]=gn.scales;gn.values[0]=pe!=null?es(L.ori==0?Yt:tn,pe):null,gn.values[1]=ve!=null?es(L.ori==1?Yt:tn,ve):null}oa(kh,i,Yt,tn,We,fe,N)}if(Fn){let pe=P&&gn.setSeries,ve=ht.prox;gr==null?ms<=ve&&Qi(Us,eo,!0,pe):ms>ve?Qi(null,eo,!0,pe):Us!=gr&&Qi(Us,eo,!0,pe)}}qe&&(ue.idx=N,Ch()),M!==!1&&Ln("setCursor")}let Os=null;Object.defineProperty(i,"rect",{get(){return Os==null&&ra(!1),Os}});function ra(_=!1){_?Os=null:(Os=m.getBoundingClientRect(),Ln("syncRect",Os))}function dp(_,M,P,N,B,Z,re){_e._lock||Ds&&_!=null&&_.movementX==0&&_.movementY==0||(Rh(_,M,P,N,B,Z,re,!1,_!=null),_!=null?_r(null,!0,!0):_r(M,!0,!1))}function Rh(_,M,P,N,B,Z,re,pe,ve){if(Os==null&&ra(!1),Ne(_),_!=null)P=_.clientX-Os.left,N=_.clientY-Os.top;else{if(P<0||N<0){Yt=-10,tn=-10;return}let[Re,Le]=gn.scales,Fe=M.cursor.sync,[tt,Et]=Fe.values,[yt,dt]=Fe.scales,[Ze,He]=gn.match,Zt=M.axes[0].side%2==1,ln=L.ori==0?We:fe,Nn=L.ori==1?We:fe,kt=Zt?Z:B,cn=Zt?B:Z,di=Zt?N:P,Zn=Zt?P:N;if(yt!=null?P=Ze(Re,yt)?a(tt,b[Re],ln,0):-10:P=ln*(di/kt),dt!=null?N=He(Le,dt)?a(Et,b[Le],Nn,0):-10:N=Nn*(Zn/cn),L.ori==1){let Ai=P;P=N,N=Ai}}ve&&(M==null||M.cursor.event.type==kh)&&((P<=1||P>=We-1)&&(P=br(P,We)),(N<=1||N>=fe-1)&&(N=br(N,fe))),pe?(op=P,ap=N,[Jr,jr]=_e.move(i,P,N)):(Yt=P,tn=N)}let Ph={width:0,height:0,left:0,top:0};function Ih(){xl(Ph,!1)}let fp,pp,mp,gp;function _p(_,M,P,N,B,Z,re){Ds=!0,Pn=In=On._x=On._y=!1,Rh(_,M,P,N,B,Z,re,!0,!1),_!=null&&(vt(Vh,Xh,xp,!1),oa(Fp,i,Jr,jr,We,fe,null));let{left:pe,top:ve,width:Re,height:Le}=$t;fp=pe,pp=ve,mp=Re,gp=Le}function xp(_,M,P,N,B,Z,re){Ds=On._x=On._y=!1,Rh(_,M,P,N,B,Z,re,!1,!0);let{left:pe,top:ve,width:Re,height:Le}=$t,Fe=Re>0||Le>0,tt=fp!=pe||pp!=ve||mp!=Re||gp!=Le;if(Fe&&tt&&xl($t),On.setScale&&Fe&&tt){let Et=pe,yt=Re,dt=ve,Ze=Le;if(L.ori==1&&(Et=ve,yt=Le,dt=pe,Ze=Re),Pn&&Fs(T,es(Et,T),es(Et+yt,T)),In)for(let He in b){let Zt=b[He];He!=T&&Zt.from==null&&Zt.min!=Ht&&Fs(He,es(dt+Ze,He),es(dt,He))}Ih()}else _e.lock&&(_e._lock=!_e._lock,_r(M,!0,_!=null));_!=null&&(Lt(Vh,Xh),oa(Vh,i,Yt,tn,We,fe,null))}function nv(_,M,P,N,B,Z,re){if(_e._lock)return;Ne(_);let pe=Ds;if(Ds){let ve=!0,Re=!0,Le=10,Fe,tt;L.ori==0?(Fe=Pn,tt=In):(Fe=In,tt=Pn),Fe&&tt&&(ve=Yt<=Le||Yt>=We-Le,Re=tn<=Le||tn>=fe-Le),Fe&&ve&&(Yt=Yt<Jr?0:We),tt&&Re&&(tn=tn<jr?0:fe),_r(null,!0,!0),Ds=!1}Yt=-10,tn=-10,de.fill(null),_r(null,!0,!0),pe&&(Ds=pe)}function vp(_,M,P,N,B,Z,re){_e._lock||(Ne(_),ta(),Ih(),_!=null&&oa(Bp,i,Yt,tn,We,fe,null))}function yp(){C.forEach(ab),k(i.width,i.height,!0)}wr(Rl,lo,yp);let to={};to.mousedown=_p,to.mousemove=dp,to.mouseup=xp,to.dblclick=vp,to.setSeries=(_,M,P,N)=>{let B=gn.match[2];P=B(i,M,P),P!=-1&&Qi(P,N,!0,!1)},Qe&&(vt(Fp,m,_p),vt(kh,m,dp),vt(Up,m,_=>{Ne(_),ra(!1)}),vt(Op,m,nv),vt(Bp,m,vp),Qh.add(i),i.syncRect=ra);let vl=i.hooks=n.hooks||{};function Ln(_,M,P){Yr?na.push([_,M,P]):_ in vl&&vl[_].forEach(N=>{N.call(null,i,M,P)})}(n.plugins||[]).forEach(_=>{for(let M in _.hooks)vl[M]=(vl[M]||[]).concat(_.hooks[M])});let bp=(_,M,P)=>P,gn=_n({key:null,setSeries:!1,filters:{pub:Zp,sub:Zp},scales:[T,S[1]?S[1].scale:null],match:[Kp,Kp,bp],values:[null,null]},_e.sync);gn.match.length==2&&gn.match.push(bp),_e.sync=gn;let Mp=gn.key,Lh=qm(Mp);function oa(_,M,P,N,B,Z,re){gn.filters.pub(_,M,P,N,B,Z,re)&&Lh.pub(_,M,P,N,B,Z,re)}Lh.sub(i);function iv(_,M,P,N,B,Z,re){gn.filters.sub(_,M,P,N,B,Z,re)&&to[_](null,M,P,N,B,Z,re)}i.pub=iv;function sv(){Lh.unsub(i),Qh.delete(i),qt.clear(),$h(Rl,lo,yp),c.remove(),ae?.remove(),Ln("destroy")}i.destroy=sv;function Nh(){Ln("init",n,e),_l(e||n.data,!1),O[T]?Th(T,O[T]):ta(),Xe=$t.show&&($t.width>0||$t.height>0),Oe=qe=!0,k(n.width,n.height)}return S.forEach(pl),C.forEach(Qo),t?t instanceof HTMLElement?(t.appendChild(c),Nh()):t(i,Nh):Nh(),i}wn.assign=_n;wn.fmtNum=od;wn.rangeNum=Pl;wn.rangeLog=Nl;wn.rangeAsinh=sd;wn.orient=Er;wn.pxRatio=At;wn.join=jv;wn.fmtDate=ld,wn.tzDate=cy;wn.sync=qm;{wn.addGap=Xy,wn.clipGaps=Ul;let n=wn.paths={points:jm};n.linear=eg,n.stepped=$y,n.bars=Zy,n.spline=Jy}function sg(n,e,t,i,s){return r=>{let{ctx:o,bbox:a}=r,l=devicePixelRatio,c=d=>r.valToPos(d*i,"x",!0),u=d=>d>=a.left-1&&d<=a.left+a.width+1;if(o.save(),n.window){let d=Math.max(a.left,c(n.window.from)),h=Math.min(a.left+a.width,c(n.window.to));o.fillStyle=t.window,h>d&&o.fillRect(d,a.top,h-d,a.height)}o.lineWidth=2*l,o.strokeStyle=t.limit;for(let{value:d}of e){let h=r.valToPos(d*s,"y",!0);h<a.top||h>a.top+a.height||(o.beginPath(),o.moveTo(a.left,h),o.lineTo(a.left+a.width,h),o.stroke())}o.lineWidth=l,o.strokeStyle=t.event,o.fillStyle=t.event,o.setLineDash([2*l,3*l]),o.font=`600 ${11*l}px system-ui, sans-serif`,o.textAlign="center",o.textBaseline="bottom",(n.events??[]).forEach((d,h)=>{let f=c(d.x);u(f)&&(o.beginPath(),o.moveTo(f,a.top),o.lineTo(f,a.top+a.height),o.stroke(),o.fillText(String(h+1),f,a.top-2*l))}),o.restore()}}var rg="12px system-ui, sans-serif";function Gs(n,e){let t=0;for(let i of n.curves){let s=un(i.y);s&&(t=Math.max(t,Math.abs(s[0]),Math.abs(s[1])))}return{xScale:Gt(Sl[n.along],e,1),yScale:Gt(n.yUnit,e,t)}}function ma(n,e){return e.symbol?`${n}, ${e.symbol}`:n}function lb(n,e,t){let i=ki(t.theme).curve[n.role],s={label:n.label,show:!t.hidden.has(e),stroke:i,width:n.points?0:so[n.role],dash:io[n.role],points:n.points?{show:!0,size:6,space:0,fill:ki(t.theme).paper,stroke:i,width:1.5}:{show:!1}};return n.points&&(s.paths=()=>null),s}function cb(n,e,t,i){let s=ki(e.theme),r={stroke:s.muted,font:rg,labelFont:rg,labelSize:20,grid:{stroke:s.grid,width:1},ticks:{stroke:s.grid,width:1,size:4},values:(a,l)=>aa(l)},o=Math.max(3,Math.floor(e.width/110));return[{...r,label:ma(n.xLabel,t),size:30,splits:(a,l,c,u)=>ro(c,u,o)},{...r,label:ma(n.yLabel,i),size:(a,l)=>16+7*Math.max(2,...(l??[]).map(c=>String(c).length)),splits:(a,l,c,u)=>ro(c,u,Math.max(3,e.height/55))}]}function og(n,e,t){let i=Bs(e.curves),{xScale:s,yScale:r}=Gs(e,t.units),o=un(i.x)??[0,1];o[0]===o[1]&&(o[1]=o[0]+1);let a=s.factor,l=r.factor,c=g=>g.map(p=>p==null?p:p*l),u=[i.x.map(g=>g*a),...i.y.map(c)],d=t.zoom??o,h=ki(t.theme),f=[{},...e.curves.map((g,p)=>lb(g,p,t))],m=(g,p,S)=>{let[C,b]=Ml(e,(p??0)/l,(S??l)/l);return[C*l,b*l]},v=new wn({width:t.width,height:t.height,padding:[18,14,0,0],pxAlign:0,legend:{show:!1},cursor:{y:!1,drag:{x:!0,y:!1,dist:5},points:{size:7,fill:h.paper,width:2}},scales:{x:{time:!1,range:(g,p,S)=>p===null||S===null?[0,1]:[p,S]},y:{range:m}},axes:cb(e,t,s,r),series:f,bands:e.band?[{series:[e.band.high+1,e.band.low+1],fill:h.band}]:[],hooks:{setCursor:[g=>{let{left:p,event:S}=g.cursor;S&&t.onCursor(p===void 0||p<0?null:g.posToVal(p,"x")/a)}],setScale:[(g,p)=>{let{min:S,max:C}=g.scales.x;p==="x"&&typeof S=="number"&&typeof C=="number"&&t.onZoom([S/a,C/a])}],drawAxes:[sg(e,yr(e),h,a,l)]}},u,n);return v.setScale("x",{min:d[0]*a,max:d[1]*a}),{chart:v,aligned:i,xScale:s,yScale:r,reach:o}}var _o=680,xs=250,Ws=58,_a=12,Hs=16,Ar=40,ss=ki("light");function ub(n,e,t,i,s,r){let o="",a=!1,l=NaN,c=NaN;return n.x.forEach((u,d)=>{let h=n.y[e]?.[d];if(h===void 0||u<t||u>i)return;if(h===null){a=!1;return}let[f,m]=[s(u),r(h)];a&&Math.abs(f-l)<.25&&Math.abs(m-c)<.25||(o+=`${a?"L":"M"}${f.toFixed(1)} ${m.toFixed(1)}`,[a,l,c]=[!0,f,m])}),o}function hb(n,e,t,i,s){let o=n.x.map((c,u)=>({x:c,low:n.y[e]?.[u],high:n.y[t]?.[u]})).filter(c=>typeof c.low=="number"&&typeof c.high=="number");if(o.length<2)return"";let a=o.map(c=>`${i(c.x).toFixed(1)} ${s(c.high).toFixed(1)}`),l=o.reverse().map(c=>`${i(c.x).toFixed(1)} ${s(c.low).toFixed(1)}`);return`M${a.join("L")}L${l.join("L")}Z`}function ga(n,e,t,i,s=ss.muted){return it("text",{x:n,y:e,"text-anchor":i,fill:s,"font-size":11},t)}function db(n,e,t,i,s,r){let{xScale:o,yScale:a}=Gs(n,e),l=[],c=ro(t[0]*o.factor,t[1]*o.factor,8),u=ro(i[0]*a.factor,i[1]*a.factor,5);aa(c).forEach((h,f)=>{let m=s(c[f]/o.factor);l.push(it("path",{d:`M${m} ${Hs}V${xs-Ar}`,stroke:ss.grid})),l.push(ga(m,xs-Ar+14,h,"middle"))}),aa(u).forEach((h,f)=>{let m=r(u[f]/a.factor);l.push(it("path",{d:`M${Ws} ${m}H${_o-_a}`,stroke:ss.grid})),l.push(ga(Ws-6,m+4,h,"end"))}),l.push(ga((Ws+_o-_a)/2,xs-6,ma(n.xLabel,o),"middle"));let d=ga(0,0,ma(n.yLabel,a),"middle");return d.setAttribute("transform",`translate(12 ${(Hs+xs-Ar)/2}) rotate(-90)`),l.push(d),l}function ag(n,e,t,i){let s=Bs(n.curves),r=t??un(s.x)??[0,1],o=Ml(n,...Ap(s,r[0],r[1],i)),a=m=>Ws+(m-r[0])/(r[1]-r[0]||1)*(_o-Ws-_a),l=m=>xs-Ar-(m-o[0])/(o[1]-o[0]||1)*(xs-Hs-Ar),c=`clip-${n.id}`,u={x:Ws,y:Hs,width:_o-Ws-_a,height:xs-Hs-Ar},d=db(n,e,r,o,a,l),h=it("g",{"clip-path":`url(#${c})`,fill:"none"});if(n.window){let m=a(n.window.from);h.append(it("rect",{x:m,y:Hs,width:Math.max(0,a(n.window.to)-m),height:u.height,fill:ss.window}))}n.band&&h.append(it("path",{d:hb(s,n.band.low,n.band.high,a,l),fill:ss.band})),n.curves.forEach((m,v)=>{if(i.has(v))return;let g=ss.curve[m.role];if(m.points){m.x.forEach((C,b)=>{let E=m.y[b];C===null||E===null||E===void 0||h.append(it("circle",{cx:a(C),cy:l(E),r:2.4,fill:ss.paper,stroke:g}))});return}let p=io[m.role].join(" ")||null,S=ub(s,v,r[0],r[1],a,l);h.append(it("path",{d:S,stroke:g,"stroke-width":so[m.role]*.75,"stroke-dasharray":p}))});for(let{value:m}of yr(n))h.append(it("path",{d:`M${Ws} ${l(m)}H${_o-_a}`,stroke:ss.limit,"stroke-width":1.5}));(n.events??[]).forEach((m,v)=>{m.x<r[0]||m.x>r[1]||(h.append(it("path",{d:`M${a(m.x)} ${Hs}V${xs-Ar}`,stroke:ss.event,"stroke-dasharray":"2 3"})),d.push(ga(a(m.x),Hs-4,String(v+1),"middle",ss.event)))});let f={viewBox:`0 0 ${_o} ${xs}`,class:"paper-figure",role:"img","aria-label":n.title};return it("svg",f,it("clipPath",{id:c},it("rect",u)),...d,h)}function lg(n,e){let{xScale:t,yScale:i}=Gs(n,e),s=Bs(n.curves),r=[{label:n.xLabel,unit:t.symbol},...n.curves.map(a=>({label:a.label,unit:i.symbol}))],o=s.x.map((a,l)=>[a*t.factor,...s.y.map(c=>{let u=c[l];return typeof u=="number"?u*i.factor:u})]);return{name:`hawser-${n.id}`,columns:r,rows:o}}var fb=400;function pb(n){if(n==null)return"";if(typeof n=="number")return Number.isFinite(n)?String(Number(n.toPrecision(12))):"";let e=/^[=+\-@]/.test(n)?`'${n}`:n;return/[",\r\n]/.test(e)?`"${e.replaceAll('"','""')}"`:e}var ug=n=>n.unit?`${n.label}, ${n.unit}`:n.label;function cg(n){return[n.columns.map(ug),...n.rows].map(t=>t.map(pb).join(",")).join(`\r
`)+`\r
`}async function mb(n){try{return await navigator.clipboard.writeText(n),!0}catch{let e=I("textarea",{class:"offscreen",readonly:!0});e.value=n,document.body.append(e),e.select();let t=document.execCommand("copy");return e.remove(),t}}function gb(n,e){let t=URL.createObjectURL(new Blob([e],{type:"text/csv"}));I("a",{href:t,download:`${n}.csv`}).click(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}function md(n,e,t=6){let i=n.rows.slice(0,fb),r=n.rows.length>i.length?` (the first ${i.length} of ${n.rows.length} rows; the CSV has all)`:"",o=i.map(l=>I("tr",{},...l.map(c=>typeof c=="number"?I("td",{class:"number"},hn(c,t)):I("td",{},c===null?si:mt(c??""))))),a=I("tr",{},...n.columns.map(l=>I("th",{scope:"col"},ug(l))));return I("div",{class:"scroll",tabindex:0,role:"region","aria-label":e},I("table",{class:"data"},I("caption",{},e+r),I("thead",{},a),I("tbody",{},...o)))}function Hi(n){let e=I("span",{class:"said",role:"status"}),t=jn("Copy CSV",()=>{mb(cg(n())).then(s=>{e.textContent=s?"copied":"the browser does not allow copying",setTimeout(()=>e.textContent="",4e3)})}),i=jn("Save CSV",()=>{let s=n();gb(s.name,cg(s))});return I("div",{class:"tools"},t,i,e)}function hg(n,e,t,i){let s=I("div",{class:"behind"}),r=l=>{o.setAttribute("aria-expanded",String(l)),o.textContent=l?"Hide table":"Table",s.replaceChildren(...l?[md(n(),e)]:[])},o=jn("Table",()=>{let l=o.getAttribute("aria-expanded")!=="true";r(l),i(l)});r(t);let a=Hi(n);return a.prepend(o),[a,s]}var _b="Arrow keys move the cursor, plus and minus zoom, 0 shows all.";function xb(n,e){let{yScale:t}=Gs(n,e.get("units")),i=n.curves.filter(s=>!s.quiet).map(s=>{let r=un(s.y);if(!r)return`${s.label}: nothing known`;let[o,a]=r.map(l=>(l*t.factor).toPrecision(4));return`${s.label}: from ${o} to ${a} ${t.symbol}`});return`${n.title}. ${i.join("; ")}. ${_b}`}var Vl=class{constructor(e,t,i){this.spec=e;this.store=t;this.memory=i;this.frame=I("div",{class:"frame",tabindex:0,role:"group","aria-roledescription":"figure","aria-label":xb(e,t)},this.root),this.frame.addEventListener("keydown",l=>this.key(l));let r=hg(()=>lg(e,t.get("units")),e.title,i.open,l=>i.open=l),o=I("figcaption",{},I("p",{class:"caption"},e.caption),...r);this.element=I("figure",{id:`figure-${e.id}`,class:"figure"},I("h3",{},e.title),this.legendRoot,this.frame,this.paper,this.said,o);for(let l of["place","time"])this.ends.push(t.subscribe(l,(c,u)=>u!==this&&this.follow()));let a=new ResizeObserver(()=>this.resize());a.observe(this.frame),this.ends.push(()=>a.disconnect())}spec;store;memory;element;root=I("div",{class:"plot"});frame;paper=I("div",{class:"on-paper"});said=I("p",{class:"offscreen",role:"status"});legendRoot=I("div");ends=[];plot=null;legend=null;dispose(){for(let e of this.ends)e();this.plot?.chart.destroy(),this.plot=null}print(e){let{spec:t,store:i,memory:s}=this;this.drawLegend(e?"light":i.get("theme")),this.paper.replaceChildren(...e?[ag(t,i.get("units"),s.zoom,s.hidden)]:[])}width(){return Math.max(240,Math.floor(this.frame.clientWidth)-2)}resize(){let e=this.spec.height??(this.width()<560?220:280);this.frame.clientWidth!==0&&(this.plot&&this.plot.chart.width===this.width()||(this.plot?this.plot.chart.setSize({width:this.width(),height:e}):this.draw(e),this.follow()))}draw(e){let{spec:t,store:i,memory:s}=this;this.plot?.chart.destroy(),this.plot=og(this.root,t,{width:this.width(),height:e,theme:i.get("theme"),units:i.get("units"),hidden:s.hidden,zoom:s.zoom,onCursor:r=>this.point(r),onZoom:r=>this.remember(r)}),this.drawLegend(i.get("theme"))}drawLegend(e){let{spec:t,store:i,memory:s}=this,r=i.get("units"),o=this.plot?.aligned??Bs(t.curves);this.legend=Rp(t,o,Gs(t,r).yScale,{theme:e,units:r,hidden:s.hidden,onToggle:a=>this.toggle(a)}),this.legendRoot.replaceChildren(this.legend.element)}toggle(e){let{hidden:t}=this.memory;t.delete(e)||t.add(e),this.plot&&this.draw(this.plot.chart.height);let i=this.legendRoot.querySelectorAll("button"),s=this.spec.curves.map((r,o)=>o).filter(r=>!this.spec.curves[r]?.quiet);i[s.indexOf(e)]?.focus(),this.follow()}remember(e){let t=this.plot?.reach??e,i=(t[1]-t[0])*1e-6,s=e[0]<=t[0]+i&&e[1]>=t[1]-i;this.memory.zoom=s?null:e,this.element.classList.toggle("zoomed",!s)}point(e){this.legend?.update(e??wl(this.spec,this.store)),Oh(this.spec,this.store,e,this)}follow(){let e=wl(this.spec,this.store);this.plot&&Pp(this.plot,e),this.legend?.update(e)}key(e){let{plot:t,spec:i,store:s}=this;if(!t||e.target!==this.frame)return;let{factor:r}=t.xScale;Ip(e,{reach:()=>t.reach,view:()=>this.memory.zoom??t.reach,cursor:()=>wl(i,s),move:o=>{Oh(i,s,o,null),this.said.textContent=this.legend?.sentence()??""},zoom:([o,a])=>{t.chart.setScale("x",{min:o*r,max:a*r}),this.follow()}})}};function Mt(n,e){let t=n?.[e];return Array.isArray(t)?t.map(i=>typeof i=="number"&&Number.isFinite(i)?i:null):null}function Xs(n,e){let t=n?.[e];return Array.isArray(t)?t.map(i=>String(i??"")):[]}function nn(n){return!!n&&n.some(e=>e!=null)}var vb={pull:"Tension in the cable",attachment:"Tension at eye or net",sidewall:"Sidewall pressure",bend_radius:"Bend radius of the cable",rope_bend:"Bend of the rope, over its diameter",roller_steady:"Roller load, steady",roller_peak:"Roller load, peak",rope:"Pull of the rope",winch:"Pull of the winch",push:"Force of a conveyor",squeeze:"Clamp of a conveyor",run_away:"Brake that is missing",alpha:"Overload factor",trip:"Trip of the winch",speed:"Speed of the pull",jam_ratio:"Jam ratio",clearance:"Clearance in the duct",fill:"Fill of the duct",weight_correction:"Weight correction factor",restart:"Restart from rest"};function kn(n){let e=vb[n]??n.replaceAll("_"," ");return e.charAt(0).toUpperCase()+e.slice(1)}function Cr(n){return n.name==="clearance"?"mm":bl(n.unit)?n.unit:"1"}function xa(n){return(n.summary.limits??[]).filter(t=>t.ok!==null&&t.margin!==null).sort((t,i)=>(t.margin??0)-(i.margin??0))}function Rr(n,e){return n.summary.limits?.find(t=>t.name===e)??null}function xo(n,...e){return e.flatMap(t=>{let i=Rr(n,t)?.limit;return typeof i=="number"?[{label:`allowed (${kn(t).toLowerCase()})`,value:i}]:[]})}function dg(n){return(n.summary.events??[]).map(e=>({x:e.time_s,label:e.what}))}function fg(n){let{from_s:e,to_s:t}=n.summary.steady_window??{};return typeof e=="number"&&typeof t=="number"&&t>e?{from:e,to:t,label:"steady window"}:void 0}function pg(n){return n.remedy??""}function va(n){let e=n.summary.verdict??"";return e.startsWith("NOT TRUSTED")?"untrusted":e.startsWith("NOT SAFE")?"unsafe":e.startsWith("SAFE")?"safe":"unjudged"}function gd(n){return n.summary.title||n.summary.case||n.label}var ba={along:"place",xLabel:"place along the route"};function ya(n,e){let t=n.map((i,s)=>s).filter(i=>n[i]!==null);return t.sort((i,s)=>n[i]-n[s]),{x:t.map(i=>n[i]??null),y:t.map(i=>e[i]??null)}}function yb(n,e,t){return n.some((i,s)=>Math.abs((i??NaN)-(e[s]??NaN))>t*Math.abs(i??0))}function bb(n){let e=n.theory_along,t=Mt(n.stations,"s_m")??[],i=[],s=(a,l,c,u)=>{let d=u?Mt(n.stations,u):null;e&&nn(c)?i.push({label:a,role:l,...ya(e.s_m,c)}):nn(d)&&i.push({label:a,role:l,...ya(t,d)})},r=e?.forward_N,o=e&&nn(e.run_N)?e.run_N:void 0;return s("reference theory","theory",o??r,"reference_N"),o&&nn(r)&&yb(o,r,.005)&&s("theory, the whole route full of cable","third",r,null),s("theory, pulled the other way","backward",e?.backward_N,null),s("paper\u2019s formulas","paper",e?.paper_N,"paper_N"),i}function zl(n){let e=n.envelope?.place,t=Mt(n.stations,"s_m")??[],i=[],s;e&&nn(e.tension_min_N)&&nn(e.tension_max_N)&&(i.push({label:"simulated, least",role:"envelope",x:e.s_m,y:e.tension_min_N,quiet:!0}),i.push({label:"simulated, largest",role:"envelope",x:e.s_m,y:e.tension_max_N,quiet:!0}),s={low:0,high:1,label:"simulated, least to largest of the run"});let r=Mt(n.stations,"mean_N");nn(r)?i.push({label:"simulated, steady mean",role:"simulated",...ya(t,r)}):e&&nn(e.tension_mean_N)&&i.push({label:"simulated, mean of the run",role:"simulated",x:e.s_m,y:e.tension_mean_N});let o=Mt(n.stations,"peak_N");if(!s&&nn(o)&&i.push({label:"simulated, peak of the run",role:"peak",...ya(t,o)}),i.push(...bb(n)),i.length===0)return null;let a=Rr(n,"pull")?.where;return{id:"tension",title:"Tension along the route",caption:"Tension of the cable that passes a place. The theory for the other direction is of the whole route full of cable."+(a?` The largest was at ${a}.`:""),...ba,yLabel:"tension",yUnit:"N",curves:i,levels:xo(n,"pull"),...s?{band:s}:{}}}function Mb(n){let e=n.theory_along;return!e||!nn(e.forward_sidewall_N_per_m)?null:{label:"reference theory, T/R",role:"theory",x:e.s_m,y:e.forward_sidewall_N_per_m}}function Sb(n){let{theory_along:e,geometry:t}=n,i=e&&nn(e.curvature_per_m)?e:t?.route;if(!i?.curvature_per_m||!nn(i.curvature_per_m))return null;let s=i.curvature_per_m.map(r=>r===null?null:Math.abs(r));return{label:"route",role:"theory",x:i.s_m,y:s}}function mg(n){let e=n.envelope?.place,t=[];e&&nn(e.sidewall_max_N_per_m)&&t.push({label:"simulated, largest of the run",role:"simulated",x:e.s_m,y:e.sidewall_max_N_per_m});let i=Mb(n);return i&&t.push(i),t.length===0?null:{id:"sidewall",title:"Sidewall pressure along the route",caption:"Force per length with which the cable presses sideways.",...ba,yLabel:"sidewall pressure",yUnit:"N/m",curves:t,levels:xo(n,"sidewall")}}function gg(n){let e=n.envelope?.place;if(!e||!nn(e.curvature_max_per_m))return null;let t=[{label:"cable, largest of the run",role:"simulated",x:e.s_m,y:e.curvature_max_per_m}],i=Sb(n);i&&t.push(i);let s=Rr(n,"bend_radius")?.limit;return{id:"curvature",title:"Curvature along the route",caption:"One over the radius to which the cable is bent. The allowed curvature is one over the allowed radius.",...ba,yLabel:"curvature",yUnit:"1/m",curves:t,levels:s?[{label:"allowed",value:1/s}]:[]}}function _g(n){let e=n.geometry;if(!e||e.route.s_m.length<2)return null;let{s_m:t,position_m:i}=e.route,s=i.map(l=>l[2]),r=[{label:"route",role:"route",x:t,y:s}],o=e.rollers.filter(l=>l.s_m!==null);o.length>0&&r.push({label:"rollers",role:"ground",points:!0,x:o.map(l=>l.s_m),y:o.map(l=>l.position_m[2])});let a=e.conveyors;if(a.length>0){let l=[],c=[];for(let{from_m:u,to_m:d}of a)l.push(u,d,d+1e-6),c.push(vr(t,s,u),vr(t,s,d),null);r.push({label:"conveyors",role:"second",x:l,y:c})}return{id:"profile",title:"Profile",caption:"Height over the place along the route; the scales of the two axes differ.",...ba,yLabel:"height",yUnit:"m",fromZero:!1,span:2,curves:r,height:200}}function xg(n){let e=Mt(n.rollers,"s_m");if(!nn(e))return null;let t=[],i=(o,a,l)=>{let c=Mt(n.rollers,o);nn(c)&&t.push({label:a,role:l,points:!0,...ya(e,c)})};if(i("steady_N","steady mean","simulated"),i("peak_N","peak of the run","second"),t.length===0)return null;let s=new Set((Mt(n.rollers,"rating_N")??[]).filter(o=>o!==null)),r=s.size===1?[...s][0]:null;return{id:"rollers",title:"Loads of the rollers along the route",caption:e.includes(null)?"Rollers that were placed by coordinates have no place along the route; the table below has all.":"Where each roller stands.",...ba,yLabel:"load",yUnit:"N",curves:t,levels:r?[{label:"rating",value:r}]:[]}}function Ma(n){let e=new Map;return n.map(t=>{let i=t.label||t.summary.title||"run",s=(e.get(i)??0)+1;return e.set(i,s),s===1?i:`${i} (${s})`})}function Gl(n,e){let t=Ma(n);return n.flatMap((i,s)=>{let r=e(i);return r&&nn(r.y)?[{label:t[s]??"",role:ks[s],...r}]:[]})}var wb=n=>{let e=zl(n)?.curves.find(({role:t})=>t==="simulated");return e?{x:e.x,y:e.y}:null},Tb=n=>{let e=n.envelope?.place;return e?.sidewall_max_N_per_m?{x:e.s_m,y:e.sidewall_max_N_per_m}:null},Eb=n=>{let[e,t]=[Mt(n.series,"time_s"),Mt(n.series,"winch_force_N")];return e&&t?{x:e,y:t}:null},Ab=n=>{let[e,t]=[Mt(n.series,"head_at_m"),Mt(n.series,"winch_force_N")],i=e?un(e):null;return e&&t&&i&&i[1]-i[0]>.5?{x:e,y:t}:null};function vg(n){return[{id:"together-tension",title:"Tension along the route, all runs",caption:"Steady means of the simulation; of a run without them the mean of the run.",along:"place",xLabel:"place along the route",yLabel:"tension",yUnit:"N",curves:Gl(n,wb)},{id:"together-sidewall",title:"Sidewall pressure along the route, all runs",caption:"The largest of each run.",along:"place",xLabel:"place along the route",yLabel:"sidewall pressure",yUnit:"N/m",curves:Gl(n,Tb)},{id:"together-force",title:"Force at the winch over time, all runs",caption:"As simulated.",along:"time",xLabel:"time",yLabel:"force",yUnit:"N",curves:Gl(n,Eb)},{id:"together-head",title:"Force at the winch over the place of the cable\u2019s head, all runs",caption:"As simulated, of the runs in which the head moves along the route.",along:"place",xLabel:"place of the cable\u2019s head along the route",yLabel:"force",yUnit:"N",curves:Gl(n,Ab)}].filter(t=>t.curves.length>1)}function Dt(n,e,...t){let i=I("h2",{id:`${n}-heading`},e);return I("section",{id:n,"aria-labelledby":`${n}-heading`},i,...t)}function pn(n){return I("p",{class:"note"},n)}var Cb={safe:"M6 12.5l4 4 8-9",unsafe:"M7 7l10 10M17 7L7 17",untrusted:"M12 6v8M12 17.2v.6",unjudged:"M7 12h10"};function qs(n){let e=it("circle",{cx:12,cy:12,r:11,fill:"currentColor"}),t=it("path",{d:Cb[n],fill:"none",stroke:"var(--surface)","stroke-width":2.6,"stroke-linecap":"round"});return it("svg",{viewBox:"0 0 24 24",class:"sign","aria-hidden":"true"},e,t)}function Hl(n,e){let i=Math.max(0,Math.min(1.5,n))*66,s=it("rect",{x:0,y:3,width:i,height:8,class:"bar",rx:1}),r=it("path",{d:"M66 0V14",class:"bar-limit"}),o=it("svg",{viewBox:"0 0 100 14",class:"usage","aria-hidden":"true",preserveAspectRatio:"none"},s,r);return I("span",{class:`usage-box ${e}`},o)}function Wl(n,e,t,i,s){let r=i.filter(({key:l})=>t.some(c=>c[l]!==void 0&&c[l]!==null&&c[l]!=="")),o=r.map(({key:l,unit:c})=>{let u=t.map(d=>typeof d[l]=="number"?Math.abs(d[l]):0);return c?Gt(c,s,Math.max(0,...u)):null}),a={name:`hawser-${n}`,columns:r.map(({label:l},c)=>({label:l,unit:o[c]?.symbol??""})),rows:t.map(l=>r.map(({key:c},u)=>{let d=l[c];return typeof d=="number"?d*(o[u]?.factor??1):d}))};return I("div",{class:"record"},md(a,e),Hi(()=>a))}function Tn(n,e,t=""){return I("div",{class:"fact"},I("dt",{},n),I("dd",{},e),t?I("dd",{class:"detail"},t):null)}function _d(n,e,t,i){if(n==null||e===null||e===void 0||n===0)return"";let s=Ke(100*e/Math.abs(n),"%",i,2);return`\xB1 ${Ke(e,t,i,2)} (${s})`}var Rb=(n,e)=>un(Mt(n.rollers,e)??[])?.[1]??null;function Pb(n){let e=(t,i,s)=>({label:t,unit:i,values:n.map(r=>s(r)??null)});return[e("Pull, steady mean","N",t=>t.summary.pull_force?.steady_mean_N),e("Pull, peak","N",t=>t.summary.pull_force?.peak_N),e("Pull by the reference theory","N",t=>t.summary.theory?.reference_total_N),e("Pull by the paper\u2019s formulas","N",t=>t.summary.theory?.paper_total_N),e("Largest roller load","N",t=>Rb(t,"peak_N")),e("Speed, steady mean","m/s",t=>t.summary.speed?.steady_m_per_s),e("Settled after","s",t=>t.summary.speed?.settle_time_s)]}function bg(n){let e=new Map;for(let t of n)for(let i of t.summary.limits??[])e.has(i.name)||e.set(i.name,{label:kn(i.name),unit:Cr(i),values:[]});for(let[t,i]of e)i.values=n.map(s=>s.summary.limits?.find(r=>r.name===t)?.value??null);return[...e.values()]}function Ib(n){return bg(n).map(e=>{let t=i=>i.summary.limits?.find(s=>kn(s.name)===e.label)?.margin??null;return{label:e.label,unit:"%",values:n.map(i=>{let s=t(i);return s===null?null:100*s})}})}function Lb(n){let e=n.map(i=>{let s=Mt(i.stations,"mean_N")??[];return new Map(Xs(i.stations,"name").map((r,o)=>[r,s[o]??null]))});return[...new Set(e.flatMap(i=>[...i.keys()]))].map(i=>({label:i,unit:"N",values:e.map(s=>s.get(i)??null)}))}function Nb(n){let e=[{label:"Key figures",rows:Pb(n)},{label:"Limits: what was found",rows:bg(n)},{label:"Limits: margin",rows:Ib(n)},{label:"Stations: mean tension",rows:Lb(n)}],t=i=>i.values.some(s=>s!==null);return e.map(({label:i,rows:s})=>({label:i,rows:s.filter(t)})).filter(({rows:i})=>i.length>0)}function Db(n,e){let t=n.values[0]??null;if(t===null||e===null)return"";let i=n.unit==="%"?e-t:100*(e-t)/Math.abs(t);if(!Number.isFinite(i))return"";let s=hn(i,2);return`${i>0?"+":""}${s}\u202F${n.unit==="%"?"points":"%"}`}function Fb(n,e){let t=Math.max(...n.values.map(r=>Math.abs(r??0))),i=n.unit==="%"?{symbol:"%",factor:1}:Gt(n.unit,e.units,t),s=n.values.map((r,o)=>{let a=r===null?si:hn(r*i.factor),l=o===0?"":Db(n,r);return I("td",{class:r===null?"unknown":"number"},a,l?I("span",{class:"difference"},l):null)});return I("tr",{},I("th",{scope:"row"},mt(n.label),i.symbol?`, ${i.symbol}`:""),...s)}function Ub(n,e){return{name:"hawser-comparison",columns:["group","figure","unit",...e].map(t=>({label:t})),rows:n.flatMap(t=>t.rows.map(i=>[t.label,i.label,i.unit,...i.values]))}}var yg=24;function Mg(n){let{runs:e}=n.data;if(e.length<2)return null;let t=Ma(e),i=Nb(e),s=e.map(h=>{let f=va(h),m={safe:"safe",unsafe:"not safe",untrusted:"not trusted",unjudged:"not judged"};return I("td",{},I("span",{class:`standing-word ${f}`},qs(f),m[f]))}),r=t.map((h,f)=>{let m=n.store.get("run")===f,v=I("button",{type:"button",class:"pick","aria-pressed":String(m),onclick:()=>n.store.set("run",f)},mt(h));return I("th",{scope:"col"},v)}),o=i.map(h=>{let f=I("tr",{class:"group"},I("th",{colspan:t.length+1,scope:"rowgroup"},h.label));return I("tbody",{},f,...h.rows.slice(0,yg).map(m=>Fb(m,n)))}),l=`Differences are from the first run. Choose a run to see all of it below, and in three dimensions.${i.some(h=>h.rows.length>yg)?" Long lists are cut; the CSV has all of them.":""}`,c=I("table",{class:"compare"},I("caption",{},l),I("thead",{},I("tr",{},I("td"),...r)),I("tbody",{},I("tr",{},I("th",{scope:"row"},"Verdict"),...s)),...o),u=I("div",{class:"scroll",tabindex:0,role:"region","aria-label":"Comparison of the runs"},c),d=vg(e).map(h=>n.figure(h));return Dt("compare","Comparison",u,Hi(()=>Ub(i,t)),...d)}function vo(n,e,t,i,s,r,o){let a=Mt(n.series,"time_s");if(!nn(a))return null;let l=o.flatMap(({name:h,label:f,role:m})=>{let v=Mt(n.series,h);return nn(v)?[{label:f,role:m,x:a,y:v}]:[]});if(l.length===0)return null;let c=fg(n),u=dg(n),d=u.length>0?" Numbers: see Events.":"";return{id:e,title:t,caption:i+d,along:"time",xLabel:"time",yLabel:s,yUnit:r,curves:l,events:u,...c?{window:c}:{}}}function Sg(n){let e=vo(n,"force","Force at the winch over time","Forces of the run, and what the theory expects.","force","N",[{name:"winch_force_N",label:"winch",role:"simulated"},{name:"max_tension_N",label:"largest tension anywhere",role:"second"},{name:"tail_tension_N",label:"tail",role:"third"},{name:"reference_N",label:"winch by the reference theory",role:"theory"}]);return e&&{...e,levels:xo(n,"pull")}}function xd(n){let e=Mt(n.series,"head_at_m"),t=Mt(n.series,"time_s"),i=nn(e)?un(e):null;if(!i||i[1]-i[0]<.5||!e||!t)return null;let s=e.map((u,d)=>d).filter(u=>e[u]!==null);s.sort((u,d)=>e[u]-e[d]);let r=u=>s.map(d=>u[d]??null),o=r(e),a=[],l=(u,d,h)=>{let f=Mt(n.series,u);nn(f)&&a.push({label:d,role:h,x:o,y:r(f)})};l("winch_force_N","simulated","simulated"),l("reference_N","reference theory","theory");let c=n.summary.pull_by_position??[];if(c.length>0){let u=d=>c.map(h=>h[d]??null);a.push({label:"simulated, means of stretches",role:"second",points:!0,x:u("head_m"),y:u("pull_N")})}return a.length===0?null:{id:"head",title:"Force at the winch over the place of the cable\u2019s head",caption:"How the pull grows while the cable comes in: what the crew sees at the winch when the head is at a place.",along:"head",xLabel:"place of the cable\u2019s head along the route",yLabel:"force",yUnit:"N",curves:a,levels:xo(n,"pull"),clock:{time:t,head:e}}}function wg(n){let e=Object.keys(n.series??{}).filter(s=>/^speed_\d+_m_per_s$/.test(s)),t=e.slice(0,ks.length),i=e.length>t.length?` The first ${t.length} of ${e.length} watched segments.`:"";return vo(n,"speed","Speeds over time",`Segments are numbered from the tail, 0.${i}`,"speed","m/s",[{name:"winch_speed_m_per_s",label:"winch",role:"theory"},...t.map((s,r)=>({name:s,label:`segment ${s.split("_")[1]}`,role:ks[r]}))])}var Eg={"vector-effect":"non-scaling-stroke"};function Ag(n){let e=t=>{let i=n.route.position_m.map(s=>s[t]);return Math.max(...i)-Math.min(...i)};return e(1)>1.2*e(0)?t=>[t[1],t[0]]:t=>[t[0],-t[1]]}function Tg(n,e,t){let i=n.map(s=>e(s).map(r=>r.toFixed(3)).join(" ")).join("L");return it("path",{d:`M${i}`,fill:"none",class:t,...Eg})}function Xl([n,e]){return`M${n} ${e}h0.001`}function vd(n,e,t){return it("path",{d:Xl(n),class:e,...Eg},it("title",{},t))}function Cg(n,e){let t=(s,r)=>s.filter(({points_m:o})=>o.length>1).map(({points_m:o})=>Tg(o,e,r)),i=[...t(n.surfaces,"plan-surface"),Tg(n.route.position_m,e,"plan-route"),...t(n.conveyors,"plan-conveyor"),...n.rollers.map(s=>vd(e(s.position_m),"plan-roller",s.name))];return n.reel&&i.push(vd(e(n.reel.center_m),"plan-reel","reel")),n.winch&&i.push(vd(e(n.winch.position_m),"plan-winch","winch")),i}function Rg(n){let t=[{name:"route",label:"route",there:!0,long:!0},{name:"roller",label:"rollers",there:n.rollers.length>0,long:!1},{name:"conveyor",label:"conveyors",there:n.conveyors.length>0,long:!0},{name:"surface",label:"ducts, trays, walls",there:n.surfaces.length>0,long:!0},{name:"reel",label:"reel",there:n.reel!==null,long:!1},{name:"winch",label:"winch",there:n.winch!==null,long:!1}].filter(({there:i})=>i).map(({name:i,label:s,long:r})=>{let o=it("path",{d:r?"M2 6H24":Xl([13,6]),class:`plan-${i}`}),a=it("svg",{width:26,height:12,class:"swatch","aria-hidden":"true"},o);return I("li",{},I("span",{class:"legend-item"},a,s))});return I("ul",{class:"legend"},...t)}function Pg(n,e,t,i){let s=null,r=1/0;return n.route.position_m.forEach((o,a)=>{let[l,c]=e(o),u=(l-t)**2+(c-i)**2;u<r&&([r,s]=[u,n.route.s_m[a]??null])}),s}function Yl(n){let e=n.map(r=>r[0]),t=n.map(r=>r[1]),[i,s]=[Math.min(...e),Math.min(...t)];return{x:i,y:s,width:Math.max(...e)-i,height:Math.max(...t)-s}}function yd(n,e){let t=Math.max(n.width,n.height*e),i=t/e;return{x:n.x+(n.width-t)/2,y:n.y+(n.height-i)/2,width:t,height:i}}function Sa(n,e){let[t,i]=[n.width*e,n.height*e];return{x:n.x+(n.width-t)/2,y:n.y+(n.height-i)/2,width:t,height:i}}var ql=(n,e,t)=>({...n,x:n.x+e*n.width,y:n.y+t*n.height});function Ob(n,e,t){switch(n){case"+":case"=":return Sa(e,.5);case"-":return e.width*2>t.width?t:Sa(e,2);case"0":return t;case"ArrowLeft":return ql(e,-.1,0);case"ArrowRight":return ql(e,.1,0);case"ArrowUp":return ql(e,0,-.1);case"ArrowDown":return ql(e,0,.1);default:return null}}var $l=class{constructor(e,t,i,s,r){this.drawing=e;this.all=i;this.onView=s;this.onPoint=r;this.view=i,e.append(this.band),e.addEventListener("mousedown",o=>{this.start=this.at(o),o.preventDefault()}),e.addEventListener("mousemove",o=>this.move(this.at(o))),e.addEventListener("mouseup",o=>this.end(this.at(o))),e.addEventListener("mouseleave",()=>{this.end(null),r(null)}),e.addEventListener("dblclick",()=>this.show(i)),t.addEventListener("keydown",o=>{let a=o.ctrlKey||o.metaKey||o.altKey?null:Ob(o.key,this.view,i);a&&(o.preventDefault(),this.show(a))}),this.show(i)}drawing;all;onView;onPoint;view;start=null;band=it("rect",{class:"plan-band","vector-effect":"non-scaling-stroke",width:0,height:0});show(e){this.view=e,this.drawing.setAttribute("viewBox",`${e.x} ${e.y} ${e.width} ${e.height}`),this.onView(e)}zoomIn(){this.show(Sa(this.view,.5))}showAll(){this.show(this.all)}at(e){let t=this.drawing.getScreenCTM();if(!t)return[0,0];let{x:i,y:s}=new DOMPoint(e.clientX,e.clientY).matrixTransform(t.inverse());return[i,s]}move(e){if(this.start)for(let[t,i]of Object.entries(Yl([this.start,e])))this.band.setAttribute(t,String(i));this.onPoint(e)}end(e){let t=this.start&&e?Yl([this.start,e]):null;this.start=null,this.band.setAttribute("width","0"),t&&Math.max(t.width,t.height)>this.view.width*.02&&this.show(yd(t,this.all.width/this.all.height))}};var Ig=900,Bb="Arrow keys move it, plus and minus zoom, 0 shows all.";function Lg(n){let{run:e,store:t,units:i}=n,s=e.geometry;if(!s||s.route.position_m.length<2)return null;let r=Ag(s),o=[s.reel?.center_m,s.winch?.position_m].filter(E=>E!==void 0),a=s.rollers.map(E=>E.position_m),l=Yl([...s.route.position_m,...a,...o].map(r)),c=Math.min(6,Math.max(1.8,l.width/Math.max(l.height,1e-9))),u=Sa(yd({...l,width:Math.max(l.width,.001)},c),1.1),d=it("path",{class:"plan-pointer","vector-effect":"non-scaling-stroke",d:""}),h=`Plan of the route, ${Ke(s.route.s_m.at(-1),"m",i)} long`,f=it("svg",{class:"plan",width:Ig,height:Ig/c,role:"img","aria-label":h},...Cg(s,r),d),m=I("div",{class:"frame",tabindex:0,role:"group","aria-label":`${h}. ${Bb}`},f),v=I("p",{class:"plan-scale"}),g=Gt("m",i,1),p={},S=new $l(f,m,u,E=>v.textContent=`Width of the drawing: ${hn(E.width*g.factor,3)} ${g.symbol}.`,E=>{let T=E&&Pg(s,r,E[0],E[1]);t.set("place",T,p),C(T)}),C=E=>{let{s_m:T,position_m:D}=s.route,[y,A,F]=[0,1,2].map(U=>E===null?null:vr(T,D.map(G=>G[U]),E)),L=typeof y=="number"&&typeof A=="number"&&typeof F=="number";d.setAttribute("d",L?Xl(r([y,A,F])):"")};n.onDispose(t.subscribe("place",(E,T)=>T!==p&&C(E))),C(t.get("place"));let b=I("div",{class:"tools"},jn("Zoom in",()=>S.zoomIn()),jn("Show all",()=>S.showAll()));return I("figure",{id:"figure-plan",class:"figure"},I("h3",{},"Plan"),Rg(s),m,I("figcaption",{},I("p",{class:"caption"},"The route from above, both directions to the same scale."),v,b))}var Zl="These results are of an older hawser, or of a run that was cut short: compute them again to have it.",Ng=n=>{let{run:e}=n,t=[],i=zl(e);t.push(i?n.figure(i):pn(`There is no tension along the route in these results. ${Zl}`));let s=mg(e);t.push(s?n.figure(s):pn(`There is no sidewall pressure along the route in these results. ${Zl}`));let r=gg(e);return r&&t.push(n.figure(r)),Dt("along","Along the route",...t)},Dg=n=>{let e=_g(n.run),t=Lg(n);return!e||!t?Dt("route","Plan and profile",pn(`There is no geometry of the route in these results. ${Zl}`)):Dt("route","Plan and profile",t,n.figure(e))},Fg=n=>{let{run:e}=n,t=[Sg(e),xd(e),wg(e)].filter(s=>s!==null);if(t.length===0)return Dt("time","Over time",pn(`There is nothing over time in these results. ${Zl}`));let i=xd(e)?null:pn("The cable\u2019s head does not move along the route in this run, so there is no force over its place.");return Dt("time","Over time",...t.map(s=>n.figure(s)),i)};function Ug(n,e){if(n==null||!e)return"";let t=100*(n-e)/e;return`simulated ${hn(Math.abs(t),2)}\u202F% ${t<0?"below":"above"}`}function kb(n){let{run:e,units:t}=n,i=Mt(e.rollers,"peak_N"),s=i?un(i)?.[1]:void 0;if(!i||s===void 0)return null;let r=i.indexOf(s),o=Mt(e.rollers,"rating_N")?.[r]??null,a=Xs(e.rollers,"name")[r]??"",l=o===null?"no rating given":`rated ${Ke(o,"N",t)}`;return Tn("Largest roller load",Ke(s,"N",t),I("span",{},mt(a),`, ${l}`))}function Og(n,e){let t=Rr(n.run,e);if(!t||t.value===null)return null;let i=e==="sidewall"?"N/m":"m",s=t.where?mt(no(t.where,n.units)):"";return Tn(kn(e),Ke(t.value,i,n.units),s)}function Bg(n){let{run:e,units:t}=n,{pull_force:i,theory:s,speed:r}=e.summary,o=s?.reference_total_N,a=un(Mt(e.series,"max_tension_N")??[])?.[1]??Rr(e,"pull")?.value,l=r?.settle_time_s,c=[Tn("Pull, steady mean",Ke(i?.steady_mean_N,"N",t),_d(i?.steady_mean_N,i?.steady_mean_error?.total_N,"N",t)),Tn("Pull, peak of the run",Ke(i?.peak_N,"N",t),_d(i?.peak_N,i?.peak_error?.total_N,"N",t)),Tn("Pull by the reference theory",Ke(o,"N",t),Ug(i?.steady_mean_N,o)),Tn("Pull by the paper\u2019s formulas",Ke(s?.paper_total_N,"N",t),Ug(i?.steady_mean_N,s?.paper_total_N)),Tn("Largest tension anywhere",Ke(a,"N",t),"rope included"),Og(n,"sidewall"),Og(n,"bend_radius"),kb(n),Tn("Speed, steady mean",Ke(r?.steady_m_per_s,"m/s",t),l==null?"":`settled after ${Ke(l,"s",t)}`)],d=i?.steady_mean_error||i?.peak_error?pn("\xB1 is what a figure may be off by through the numbers alone: steps in time, length of segments, friction at rest."):null;return Dt("key-figures","Key figures",I("dl",{class:"facts"},...c),d)}function kg(n){return n.ok===null?"unjudged":n.ok?"safe":"unsafe"}var Vg={safe:"holds",unsafe:"broken",unjudged:"not judged",untrusted:""};function Vb(n,e){let{units:t,store:i}=e,s=Cr(n),r=kg(n),o=n.margin===null?si:`${hn(100*n.margin,3)}\u202F%`,a=/^(-?\d+(?:\.\d+)?) m\b/.exec(n.where),l=a?Number(a[1]):null,c=d=>()=>{l!==null&&i.set("place",d?l:null)},u=d=>I("td",{class:d===si?"unknown":"number"},d);return I("tr",{class:r,onmouseenter:c(!0),onmouseleave:c(!1)},I("th",{scope:"row"},kn(n.name)),I("td",{class:"standing"},I("span",{class:`standing-word ${r}`},qs(r),Vg[r])),u(Ke(n.value,s,t)),u(Ke(n.limit,s,t)),u(o),I("td",{class:"usage-cell"},n.margin===null?null:Hl(1-n.margin,r)),I("td",{},mt(no(n.where,t))),I("td",{class:"source"},mt(n.source)))}var zb=["Limit","","Found","Allowed","Margin","Used","Where","Source, or why it was not judged"];function zg(n){let{run:e,units:t}=n,i=e.summary.limits;if(!i)return Dt("limits","Limits",pn("These results hold no limits: they are of an older hawser."));if(i.length===0)return Dt("limits","Limits",pn("The case has no section \u201Climits\u201D, so nothing was judged."));let s=[...xa(e),...i.filter(c=>c.ok===null||c.margin===null)],r=zb.map(c=>I("th",{scope:"col","aria-label":c||"Standing"},c)),o=I("table",{class:"limits"},I("caption",{},"The smallest margin first. The line in a bar is all that is allowed."),I("thead",{},I("tr",{},...r)),I("tbody",{},...s.map(c=>Vb(c,n)))),a=()=>({name:"hawser-limits",columns:["limit","standing","found","allowed","unit","margin","where","source"].map(c=>({label:c})),rows:s.map(c=>{let{symbol:u,factor:d}=Gt(Cr(c),t,c.limit??c.value??0),h=f=>f===null?null:f*d;return[c.name,Vg[kg(c)],h(c.value),h(c.limit),u,c.margin,c.where,c.source]})}),l=I("div",{class:"scroll",tabindex:0,role:"region","aria-label":"Table of limits"},o);return Dt("limits","Limits",l,Hi(a))}function Gb(n,e,t){let i=[...n].sort((o,a)=>Math.abs(Number(a[t]??0))-Math.abs(Number(o[t]??0))),s=new Set(i.slice(0,ks.length)),r=n.filter(o=>s.has(o)).map((o,a)=>({name:`${String(o.name)}_${e}`,label:String(o.name),role:ks[a]}));return{columns:r,left:n.length-r.length}}function Kl(n,e,t){let{columns:i,left:s}=Gb(e,t.suffix,t.size),r=s>0?` The ${i.length} largest; ${s} more are in the table of machines.`:"";return vo(n,t.id,t.title,t.caption+r,t.label,t.unit,i)}var bd=n=>n.filter(e=>e!==null);function Gg(n){let e=n.summary.conveyors??[];return bd([Kl(n,e,{id:"conveyor-force",title:"Forces of the conveyors",caption:"Force on the cable along the pull.",suffix:"force_N",size:"peak_N",label:"force",unit:"N"}),Kl(n,e,{id:"conveyor-slip",title:"Slip of the conveyors",caption:"Speed of the cable less that of the belt; 0 where there is no cable.",suffix:"slip_m_per_s",size:"peak_N",label:"slip",unit:"m/s"})])}function Hg(n){let e=n.summary.motors??[];return bd([Kl(n,e,{id:"motor-torque",title:"Torques of the driven rollers",caption:"Torque on the roller, positive with the pull.",suffix:"torque_N_m",size:"peak_N_m",label:"torque",unit:"N m"}),Kl(n,e,{id:"motor-speed",title:"Speeds of the driven rollers",caption:"Speed of the roller\u2019s surface.",suffix:"speed_m_per_s",size:"peak_N_m",label:"speed",unit:"m/s"})])}function Wg(n){return bd([vo(n,"reel-speed","Speed of the reel","Angular speed of the drum.","speed","rad/s",[{name:"reel_speed_rad_per_s",label:"reel",role:"simulated"}]),vo(n,"reel-cable","Cable on the reel","What has left the drum, and what is still on it.","length","m",[{name:"paid_out_m",label:"paid out",role:"simulated"},{name:"wound_m",label:"wound",role:"second"}])])}var Hb=[{key:"name",label:"conveyor"},{key:"from_m",label:"from",unit:"m"},{key:"to_m",label:"to",unit:"m"},{key:"grip_N",label:"largest force",unit:"N"},{key:"reference_N",label:"theory reckons with",unit:"N"},{key:"steady_mean_N",label:"steady mean",unit:"N"},{key:"peak_N",label:"peak",unit:"N"},{key:"belt_m_per_s",label:"belt",unit:"m/s"},{key:"slip_m_per_s",label:"slip",unit:"m/s"},{key:"slipping",label:"share of time slipping",unit:"1"}],Wb=[{key:"name",label:"driven roller"},{key:"at_m",label:"place",unit:"m"},{key:"limit_N_m",label:"set or largest torque",unit:"N m"},{key:"reference_N",label:"theory reckons with",unit:"N"},{key:"steady_mean_N_m",label:"steady mean",unit:"N m"},{key:"peak_N_m",label:"peak",unit:"N m"},{key:"surface_m_per_s",label:"surface",unit:"m/s"},{key:"power_W",label:"power",unit:"W"},{key:"at_limit",label:"share of time at its limit",unit:"1"}],Xb=[{key:"name",label:"surface"},{key:"kind",label:"kind"},{key:"from_m",label:"from",unit:"m"},{key:"to_m",label:"to",unit:"m"},{key:"clearance_m",label:"clearance",unit:"mm"},{key:"jam_ratio",label:"jam ratio",unit:"1"},{key:"steady_normal_N",label:"normal force, steady mean",unit:"N"},{key:"steady_friction_N",label:"friction, steady mean",unit:"N"},{key:"peak_line_load_N_per_m",label:"largest force per length",unit:"N/m"},{key:"peak_line_load_error",label:"off by at most",unit:"N/m"},{key:"peak_at_m",label:"at",unit:"m"}];function Md(n,e){return e.map(t=>n.figure(t))}var Xg=n=>{let e=n.run.summary.conveyors??[];if(e.length===0)return null;let t=Wl("conveyors","Conveyors",e,Hb,n.units);return Dt("conveyors","Conveyors",t,...Md(n,Gg(n.run)))},qg=n=>{let e=n.run.summary.motors??[];if(e.length===0)return null;let t=Wl("motors","Driven rollers",e,Wb,n.units);return Dt("motors","Driven rollers",t,...Md(n,Hg(n.run)))},Yg=n=>{let e=Wg(n.run);return e.length>0?Dt("reel","Reel",...Md(n,e)):null},$g=n=>{let e=n.run.summary.surfaces??[];return e.length===0?null:Dt("surfaces","Ducts, trays and walls",Wl("surfaces","Surfaces",e,Xb,n.units))};function Kg(n,e){return I("div",{class:"scroll",tabindex:0,role:"region","aria-label":n},e)}function Jg(...n){return I("thead",{},I("tr",{},...n.map(e=>I("th",{scope:"col"},e))))}var jg=({run:n,units:e})=>{let t=n.summary.trust;if(!t)return Dt("trust","Can these figures be trusted?",pn("These results hold no conditions of trust: they are of an older hawser."));let i=t.filter(c=>c.holds===!1).length,s=i===0?`Yes: all ${t.length} conditions hold.`:`No: ${i} of ${t.length} conditions ${i===1?"does":"do"} not hold.`,r=(c,u)=>c===null?si:bl(u)?Ke(c,u,e,3):`${hn(c,3)} ${u}`,o=c=>{let u=c.holds===!1?"unsafe":c.holds?"safe":"unjudged",d=c.holds===!1?"fails":c.holds?"holds":"not judged";return I("tr",{class:u},I("th",{scope:"row"},kn(c.name)),I("td",{class:"standing"},I("span",{class:`standing-word ${u}`},qs(u),d)),I("td",{class:"number"},r(c.value,c.unit)),I("td",{class:"number"},r(c.allowed,c.unit)),I("td",{class:"source"},c.holds===!1?mt(c.remedy):null))},a=[...t].sort((c,u)=>+(c.holds!==!1)-+(u.holds!==!1)),l=I("table",{},I("caption",{},"Conditions under which the run is worth judging."),Jg("Condition","Standing","Found","Allowed","What to do"),I("tbody",{},...a.map(o)));return Dt("trust","Can these figures be trusted?",I("p",{},s),Kg("Conditions of trust",l))},Zg={given:"given in the case",catalogue:"from the catalogue",estimated:"estimated",default:"default"};function qb(n,e){let t=new Map((e??[]).map(({key:i,source:s})=>[i,s??""]));return n?n.map(({key:i,value:s,origin:r,where:o})=>[i,s,r,o||t.get(i)||""]):(e??[]).map(({key:i,value:s,origin:r,source:o})=>[i,s,r,o??""])}var Qg=({run:n})=>{let e=qb(n.inputs,n.summary.assumptions),t="Inputs and assumptions";if(e.length===0)return Dt("inputs",t,pn("These results hold no list of inputs. The case file has them."));let i=new Map;for(let u of e)i.set(u[2]??"",(i.get(u[2]??"")??0)+1);let s=[...i].map(([u,d])=>`${d} ${Zg[u]??u}`).join(", "),r=([u="",d="",h="",f=""])=>I("tr",{class:`origin-${/^\w+$/.test(h)?h:"other"}`},I("th",{scope:"row",class:"key"},mt(u)),I("td",{},mt(d)),I("td",{},I("span",{class:"origin"},Zg[h]??mt(h))),I("td",{class:"source"},mt(f))),o=I("table",{class:"inputs"},I("caption",{},"As they were read, with their units as in the case."),Jg("Input","Value","Origin","Where from"),I("tbody",{},...e.map(r))),a=()=>({name:"hawser-inputs",columns:["input","value","origin","where from"].map(u=>({label:u})),rows:e}),l=e.filter(u=>u[2]==="estimated"||u[2]==="catalogue"),c=l.length>0?`Not from the case itself: ${l.length}. Check these first.`:"";return Dt("inputs",t,I("p",{},`${e.length} values: ${s}. ${c}`),I("details",{class:"long",open:e.length<=40},I("summary",{},"All values"),Kg("Inputs",o)),Hi(a))},e0=({run:n,data:e,units:t})=>{let{summary:i}=n,s=a=>a==null||a===""?I("span",{},si):mt(a),r=(a,l)=>Ke(i[a],l,t),o=[Tn("Case",s(i.case)),Tn("Results",s(n.label)),Tn("Simulated with",s(i.version&&`hawser ${i.version}`)),Tn("Report by",s(e.hawser&&`hawser ${e.hawser}`),e.generated?mt(e.generated):""),Tn("Simulated time",r("sim_time_s","s")),Tn("Segments",r("segments","1")),Tn("Steps",r("steps","1")),Tn("Computed in",r("wall_time_s","s")),Tn("Outcome",s(i.outcome),i.message?mt(i.message):"")];return Dt("about","Versions",I("dl",{class:"facts small"},...o))},t0=({run:n,units:e,store:t})=>{let i=n.summary.events??[];if(i.length===0)return null;let s=o=>()=>t.set("time",o),r=i.map(o=>I("li",{},I("button",{type:"button",class:"pick",onclick:s(o.time_s)},Ke(o.time_s,"s",e))," ",mt(o.what),o.pull_N===null?"":`, pull ${Ke(o.pull_N,"N",e)}`));return Dt("events","Events",I("ol",{class:"events"},...r))};var Sd=12;function Yb(n){let e=n.run.rollers,t=c=>Mt(e,c)??[],[i,s,r,o]=[t("s_m"),t("steady_N"),t("peak_N"),t("rating_N")],a=Xs(e,"name").map((c,u)=>{let[d,h]=[r[u]??null,o[u]??null],f=d===null||h===null||h<=0?null:d/h;return{index:u,name:c,place:i[u]??null,steady:s[u]??null,peak:d,rating:h,share:f}}),l=c=>c.share??-1;return a.sort((c,u)=>l(u)-l(c)||(u.peak??0)-(c.peak??0))}function n0(n,e,t){let{units:i,store:s}=e,r=n.share===null?"unjudged":n.share>1?"unsafe":"safe",o=n.share===null?si:Ke(100*(1-n.share),"%",i,3),a=c=>I("td",{class:c===si?"unknown":"number"},c),l=I("button",{type:"button",class:"pick",onclick:()=>s.set("roller",n.index),title:"Show in the 3-D view"},mt(n.name));return I("tr",{onmouseenter:()=>s.set("place",n.place),onmouseleave:()=>s.set("place",null)},I("th",{scope:"row"},l),a(n.place===null?"by coordinates":Ke(n.place,"m",i)),a(Ke(n.steady,"N",i)),a(Ke(n.peak,"N",i)),...t?[a(n.rating===null?"not given":Ke(n.rating,"N",i)),a(o),I("td",{class:"usage-cell"},n.share===null?null:Hl(n.share,r))]:[])}function i0(n){let e=Yb(n);if(!n.run.rollers)return Dt("rollers","Rollers",pn("These results hold no loads of rollers."));if(e.length===0)return null;let t=e.some(m=>m.rating!==null),i=t?"The smallest margin of the peak load against the rating first.":"No roller has a rating in this case, so there are no margins. The largest load first.",s=I("tbody",{},...e.slice(0,Sd).map(m=>n0(m,n,t))),r=e.length>Sd?jn(`Show all ${e.length} rollers`,()=>{s.append(...e.slice(Sd).map(m=>n0(m,n,t))),r?.remove()}):null,o=["Roller","Place","Steady mean","Peak",...t?["Rating","Margin of the peak","Used"]:[]],a=I("table",{class:"rollers"},I("caption",{},i),I("thead",{},I("tr",{},...o.map(m=>I("th",{scope:"col"},m)))),s),l=xg(n.run),c=Gt("N",n.units,1e3),u=Gt("m",n.units,1),d=(m,v)=>m===null?null:m*v,h=()=>({name:"hawser-roller-margins",columns:[{label:"roller"},{label:"place",unit:u.symbol},...["steady mean","peak","rating"].map(m=>({label:m,unit:c.symbol})),{label:"margin"}],rows:e.map(m=>[m.name,d(m.place,u.factor),d(m.steady,c.factor),d(m.peak,c.factor),d(m.rating,c.factor),m.share===null?null:1-m.share])}),f=I("div",{class:"scroll",tabindex:0,role:"region","aria-label":"Rollers by margin"},a);return Dt("rollers","Rollers",l?n.figure(l):null,f,r,Hi(h))}var $b={safe:"SAFE",unsafe:"NOT SAFE",untrusted:"NOT TRUSTED",unjudged:"NOT JUDGED"},Zb=new Set(["bend_radius","rope_bend","clearance"]);function Kb(n,e){let{units:t}=e,i=Cr(n),s=n.margin??0,r=s<0?`${Ke(-100*s,"%",t,3)} over`:`${Ke(100*s,"%",t,3)} left`,o=Zb.has(n.name)?"at least ":"";return I("p",{},I("strong",{},kn(n.name)),": ",I("strong",{},Ke(n.value,i,t)),n.where?" at ":"",n.where?mt(no(n.where,t)):null,`. Allowed: ${o}${Ke(n.limit,i,t)}; `,I("strong",{},r),".")}function Jb(n){let{run:e,units:t}=n,i=e.envelope?.place,s=i?.tension_max_N?{s:i.s_m,tension:i.tension_max_N,names:[]}:{s:Mt(e.stations,"s_m")??[],tension:Mt(e.stations,"peak_N")??[],names:Xs(e.stations,"name")},r=un(s.tension)?.[1];if(r===void 0)return I("p",{},"Where the tension is largest is not known.");let o=s.tension.indexOf(r),a=s.names[o];return I("p",{},I("strong",{},"Tension")," is largest at ",I("strong",{},Ke(s.s[o],"m",t)),a?" (":"",a?mt(a):null,a?")":""," along the route: ",I("strong",{},Ke(r,"N",t)),". No limit was judged.")}function jb(n){let e=xa(n.run),t=e.filter(s=>s.ok===!1),i=t.length>0?t:e.slice(0,1);return i.length>0?i.map(s=>Kb(s,n)):[Jb(n)]}var s0=n=>n.charAt(0).toUpperCase()+n.slice(1);function Qb(n){let e=n.run.summary.remedies??[];return e.length>0?e.map(i=>I("p",{},mt(`${s0(i)}.`))):xa(n.run).filter(i=>i.ok===!1).map(i=>{let s=pg(i)||`its figures alone do not tell what to change; the limit is from: ${i.source}`;return I("p",{},I("strong",{},kn(i.name)),": ",mt(s),".")})}function eM(n){let{run:e}=n,t=e.summary;switch(va(e)){case"untrusted":{let s=(t.trust??[]).filter(o=>o.holds===!1).map(o=>I("li",{},I("strong",{},kn(o.name)),": ",mt(o.remedy))),r=I("p",{},"Make the figures trustworthy first; until then no margin on this page counts.");return s.length>0?[r,I("ul",{},...s)]:[r]}case"unsafe":return[...Qb(n),I("p",{class:"detail"},"A remedy looks at its own limit alone: compute again with it.")];case"safe":{let i=(t.limits??[]).filter(r=>r.ok===null),s=i.map(r=>kn(r.name).toLowerCase()).join(", ");return[I("p",{},"Nothing has to change: every limit that was judged holds."),...i.length>0?[I("p",{class:"detail"},`Not judged: ${s}. The table of limits says what is missing.`)]:[]]}default:{let i=(t.limits??[]).filter(r=>r.ok===null);if(i.length===0)return[I("p",{},"Say what the cable may bear: give the case a section \u201Climits\u201D, and compute again.")];let s=i.map(r=>I("li",{},I("strong",{},kn(r.name)),": ",mt(r.source)));return[I("p",{},"Give the case what is missing, and compute again:"),I("ul",{},...s)]}}}function tM(n){return s0(n.replace(/^(NOT SAFE|NOT TRUSTED|NOT JUDGED|SAFE):?\s*/,""))}function r0(n){let{run:e,units:t}=n,{summary:i}=e,s=va(e),r=i.verdict?tM(i.verdict):"These results hold no verdict: they are of an older hawser, or of a run that was cut short.",o=i.outcome&&i.outcome!=="finished"?`The run ended early (${i.outcome}). ${i.message??""}`:"";return I("section",{id:"verdict",class:`verdict ${s}`,"aria-labelledby":"verdict-heading"},I("h2",{id:"verdict-heading"},qs(s),I("span",{},$b[s])),I("p",{class:"reason"},mt(r)),o?I("p",{class:"reason"},mt(o)):null,I("div",{class:"answers"},I("div",{},I("h3",{},"Where it is tightest"),...jb(n)),I("div",{},I("h3",{},"What to change"),...eM(n))),t==="us"?pn("Sentences of the program, such as the verdict\u2019s reason, are in metric units where it gave no others."):null)}function o0(n,e,t,i){let s=i.map(([r,o])=>{let a=I("input",{type:"radio",name:e,value:r,checked:n.get(e)===r,onchange:()=>n.set(e,r)});return n.subscribe(e,l=>a.checked=l===r),I("label",{},a,I("span",{},o))});return I("fieldset",{class:"choice"},I("legend",{},t),...s)}function a0(n,e){let t=o0(e,"units","Units",[["si","Metric"],["us","US"]]),i=o0(e,"theme","Colours",[["light","Light"],["dark","Dark"]]),s=I("div",{class:"toolbar",role:"toolbar","aria-label":"The page"});if(n.runs.length>1){let r=I("select",{id:"run-choice",onchange:()=>e.set("run",Number(r.value))});Ma(n.runs).forEach((o,a)=>r.append(I("option",{value:a},o.slice(0,60)))),e.subscribe("run",o=>r.value=String(o)),s.append(I("label",{class:"run-choice"},"Run ",r))}return s.append(t,i,jn("Print",()=>print(),{class:"print"})),s}var l0=()=>new Promise(n=>{let{port1:e,port2:t}=new MessageChannel;e.onmessage=()=>{e.close(),n()},t.postMessage(0)});async function nM(n){let e=n.endsWith("==")?2:n.endsWith("=")?1:0,t=new Uint8Array(n.length/4*3-e),i=0;for(let s=0;s<n.length;s+=1048576){let r=atob(n.slice(s,s+1048576));for(let o=0;o<r.length;o++)t[i++]=r.charCodeAt(o);s+1048576<n.length&&await l0()}return t}async function iM(n){let e=new Blob([n]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(e).arrayBuffer())}async function Jl(n,e,t,i){let s=e*t*i,r=await iM(await nM(n));if(r.length!==4*s)throw new Error(`a field has ${r.length} bytes, not ${4*s}`);let o=new Int32Array(s),a=t*i,l=performance.now();for(let c=0;c<e;c++)sM(r,o,s,c*a,a,i),performance.now()-l>6&&(await l0(),l=performance.now());return o}function sM(n,e,t,i,s,r){let o=i===0;for(let a=0;a<s;a++){let l=i+a,c=n[l]|n[l+t]<<8|n[l+2*t]<<16|n[l+3*t]<<24,u=c>>>1^-(c&1);a>=r&&(u+=e[l-r]-(o?0:e[l-s-r])),o||(u+=e[l-s]),e[l]=u}}function wd(n,e){let t=0,i=n.length-1;for(;t<i;){let s=t+i+1>>1;n[s]<=e?t=s:i=s-1}return t}var wa=class{constructor(e,t){this.items=t;this.time=Float64Array.from(e)}items;time;fields=new Map;get count(){return this.time.length}get from(){return this.time[0]??0}get to(){return this.time[this.count-1]??0}between(e){let t=wd(this.time,e),i=Math.min(t+1,this.count-1),s=this.time[i]-this.time[t];return{frame:t,next:i,part:s>0?Math.min(1,Math.max(0,(e-this.time[t])/s)):0}}sample(e,t,i,s=[]){let r=this.fields.get(e);if(!r)return!1;let{components:o,step:a}=r.meta,l=this.items*o,c=t.frame*l,u=t.next*l,d=r.q;for(let h=0;h<o;h++){let f=s[h]??0;for(let m=h;m<l;m+=o){let v=d[c+m];i[m]=a*(v+t.part*(d[u+m]-v))-f}}return!0}history(e,t){let i=this.fields.get(e);if(!i)return null;let{components:s,step:r}=i.meta;return Float64Array.from(this.time,(o,a)=>{let l=(a*this.items+t(a))*s,c=0;if(s===1)return r*i.q[l];for(let u=0;u<s;u++)c+=i.q[l+u]**2;return r*Math.sqrt(c)})}};async function c0(n,e){let t=new wa(n.time_s,n.segments),i=Object.keys(n.packed).sort((s,r)=>+(r==="position")-+(s==="position"));for(let s of i){let r=n.fields[s];if(!r)continue;let o=await Jl(n.packed[s],n.frames,n.segments,r.components);t.fields.set(s,{meta:r,q:o}),e(t,s)}return t}var Ft=(n,e)=>[n[0]-e[0],n[1]-e[1],n[2]-e[2]],Ut=(n,e,t=1)=>[n[0]+t*e[0],n[1]+t*e[1],n[2]+t*e[2]],Ii=(n,e)=>n[0]*e[0]+n[1]*e[1]+n[2]*e[2],rs=(n,e)=>[n[1]*e[2]-n[2]*e[1],n[2]*e[0]-n[0]*e[2],n[0]*e[1]-n[1]*e[0]],xi=n=>Math.hypot(n[0],n[1],n[2]);function dn(n,e=[1,0,0]){let t=xi(n);return t>1e-12?[n[0]/t,n[1]/t,n[2]/t]:e}var jl=class{constructor(e,t){this.s=e;this.points=t;this.along=t.slice(1).map((i,s)=>dn(Ft(i,t[s])))}s;points;along;get from(){return this.s[0]??0}get to(){return this.s[this.points.length-1]??0}piece(e){return Math.max(0,Math.min(this.points.length-2,wd(this.s,e)))}at(e){let t=this.piece(e),i=this.s[t+1]-this.s[t],s=(e-this.s[t])/i;if(s>=0&&s<=1)return Ut(this.points[t],Ft(this.points[t+1],this.points[t]),s);let r=s<0?t:t+1;return Ut(this.points[r],this.along[t],e-this.s[r])}tangent(e){return this.along[this.piece(e)]??[1,0,0]}nearest([e,t,i]){let{s,points:r,along:o}=this,a=1/0,l=this.from;for(let c=0;c+1<r.length;c++){let u=r[c],d=o[c],h=e-u[0],f=t-u[1],m=i-u[2],v=s[c+1]-s[c],g=Math.min(v,Math.max(0,h*d[0]+f*d[1]+m*d[2])),p=(h-g*d[0])**2+(f-g*d[1])**2+(m-g*d[2])**2;p<a&&(a=p,l=s[c]+g)}return{s:l,distance:Math.sqrt(a)}}};var yo=[0,0,1],Td=n=>n*Math.PI/180;function Ql(n){let e=Math.max(1,n.length),t=n.reduce((c,u)=>Ut(c,u,1/e),[0,0,0]),i=0,s=0,r=0;for(let c of n){let[u,d]=Ft(c,t);i+=u*u,s+=u*d,r+=d*d}let o=.5*Math.atan2(2*s,i-r),a=[Math.cos(o),Math.sin(o),0],l=n.length>1?Ft(n[e-1],n[0]):a;return Ii(l,a)<0?[-a[0],-a[1],0]:a}function ec(n,e,t,i,s=.12){let r=dn(rs(yo,e),[0,1,0]),o=rs(e,r),a=Math.tan(Td(t)/2)*(1-s),l=rM(n,[r,o,e]),c=0;for(let u=0;u<4;u++){c=1;for(let f of n){let m=Ft(f,l),v=Math.max(Math.abs(Ii(m,r))/(a*i),Math.abs(Ii(m,o))/a);c=Math.max(c,Ii(m,e)+v)}let d=n.map(f=>{let m=Ft(f,l),v=Math.max(1e-6,c-Ii(m,e));return[Ii(m,r)/v,Ii(m,o)/v]}),h=f=>{let m=d.map(v=>v[f]);return .5*(m.reduce((v,g)=>Math.min(v,g))+m.reduce((v,g)=>Math.max(v,g)))};l=Ut(Ut(l,r,h(0)*c),o,h(1)*c)}return{position:Ut(l,e,c),target:l,fov:t}}function rM(n,e){return e.reduce((t,i)=>{let s=n.map(a=>Ii(a,i)),r=s.reduce((a,l)=>Math.min(a,l),1/0),o=s.reduce((a,l)=>Math.max(a,l),-1/0);return Ut(t,i,.5*(r+o))},[0,0,0])}function tc(n,e){let t=rs(n,yo);return dn(Ut([0,0,Math.sin(Td(e))],t,Math.cos(Td(e))))}var u0=(n,e)=>ec(n,tc(Ql(n),32),35,e),h0=(n,e)=>ec(n,tc(Ql(n),89.9),20,e),d0=(n,e)=>ec(n,tc(Ql(n),2),20,e);function f0(n,e,t){let i=n.tangent(e),s=dn(rs(i,yo),[0,1,0]),r=dn([i[0],i[1],0],i),o=n.at(e);return{position:Ut(Ut(Ut(o,r,-t),s,.35*t),yo,.4*t),target:o,fov:50}}function p0(n,e,t){let i=e.to-e.from,s=Math.max(.5,.15*i),r=Math.max(n.from,e.from-s),o=Math.min(n.to,e.to+s),a=Array.from({length:33},(h,f)=>n.at(r+(o-r)*f/32)),l=Ft(n.tangent(e.to+1e-6),n.tangent(Math.max(n.from,e.from-1e-6))),c=Math.abs(l[2])>Math.hypot(l[0],l[1]),u=xi(Ft(a[32],a[0]))*.03,d=a.flatMap(h=>[Ut(h,yo,u),Ut(h,yo,-u)]);return ec(d,tc(Ql(a),c?12:48),35,t)}function m0(n,e,t){let i=t*t*(3-2*t);return{position:Ut(n.position,Ft(e.position,n.position),i),target:Ut(n.target,Ft(e.target,n.target),i),fov:n.fov+(e.fov-n.fov)*i}}function bo(n,e,t){let i=dn(Ft(n.position,n.target));return{position:Ut(e,i,t),target:e,fov:n.fov}}var oM=60,Ed=n=>Math.max(2.5,40*n.diameter),nc=class{constructor(e,t,i){this.world=e;this.now=t;this.time=i}world;now;time;followed=null;atBend=-1;onChange=()=>{};get model(){return this.world.model}changed(){this.onChange(this.atBend<0?null:this.atBend,this.followed!==null)}preset(e,t,i=!1){let{extent:s}=this.model,{stage:r}=this.world,o=[()=>u0(s,r.aspect),()=>this.behind(t),()=>h0(s,r.aspect),()=>d0(s,r.aspect)];e!==1&&(this.followed=null),this.atBend=-1,r.go(o[e](),i),this.changed()}behind(e){let{model:t}=this,i=this.now();if(!t.path)return bo(this.world.stage.pose,i?.centre(t.head)??[0,0,0],Ed(t));let s=i?.headPlace(this.time())??t.path.from;return f0(t.path,e??Math.min(t.path.to,s),Ed(t))}bend(e){let{bends:t,path:i}=this.model,s=t[e];!i||!s||(this.followed=null,this.atBend=e,this.world.stage.go(p0(i,s,this.world.stage.aspect)),this.changed())}nextBend(e){let t=this.model.bends.length;t>0&&this.bend((this.atBend+e+(this.atBend<0&&e<0?1:0)+t)%t)}follow(e=!this.followed){let t=this.now(),{stage:i}=this.world;this.followed=e&&t?t.centre(this.model.head):null,this.followed&&i.go(bo(i.pose,this.followed,Math.min(i.distance,oM))),this.changed()}goWithHead(e){if(!this.followed)return;let t=e.centre(this.model.head);this.world.stage.shift(Ft(t,this.followed)),this.followed=t}lookAt(e){let{stage:t}=this.world;t.go(bo(t.goal,e,Ed(this.model)*2))}};var Ad=[{field:"tension",title:"Tension",unit:"N"},{field:"sidewall",title:"Sidewall pressure",unit:"N/m"},{field:"curvature",title:"Curvature",unit:"1/m"},{field:"speed",title:"Speed",unit:"m/s"},{field:"contact",title:"Contact force per length",unit:"N/m"}];function Li(n,e){let{symbol:t,factor:i}=Gt("m",e,n);return`${(n*i).toFixed(1).replace("-","\u2212")}\xA0${t}`}function Ta(n,e){if(e<600)return`${n.toFixed(1)}\xA0s`;let t=s=>String(Math.floor(s)).padStart(2,"0"),i=t(n%60);return e<3600?`${Math.floor(n/60)}:${i}\xA0min`:`${Math.floor(n/3600)}:${t(n/60%60)}:${i}\xA0h`}var sc=[{name:"Overview",key:"1",title:"The whole route"},{name:"Along",key:"2",title:"Behind the head, along the cable"},{name:"Plan",key:"3",title:"From above"},{name:"Profile",key:"4",title:"From the side"}],Ea=5,_0=5,x0=100,v0=100;function Cd(n,e){let t=(n.angle*180/Math.PI).toFixed(0);return`Bend ${n.number}: ${t}\xB0, R ${Li(n.radius,e)}`}var ic=class{constructor(e,t,i){this.bends=e;let s=sc.map(({name:r,key:o,title:a},l)=>jn(r,()=>i.preset(l),{title:`${a} (${o})`,"aria-keyshortcuts":o}));this.bendList=I("select",{"aria-label":"Go to a bend",hidden:e.length===0}),this.bendList.addEventListener("change",()=>{this.bendList.value&&i.bend(Number(this.bendList.value))}),this.colours=I("select",{},...t.map(({field:r,title:o})=>I("option",{value:r},o))),this.colours.addEventListener("change",()=>i.colour(this.colours.value)),this.slider.setAttribute("aria-label","Diameter drawn, times the true one"),this.slider.addEventListener("input",()=>{let r=this.slider.valueAsNumber;this.slider.setAttribute("aria-valuetext",r===0?"as suits the view":`times ${g0(r).toFixed(1)}`),i.factor(r===0?null:g0(r))}),this.root=I("div",{class:"view-tools"},I("div",{class:"view-presets",role:"group","aria-label":"Camera"},...s,this.bendList),I("label",{class:"view-field"},"Colour",this.colours),I("label",{class:"view-field",title:"Left end: as suits the view"},"Diameter: auto",this.slider,`\xD7${x0}`)),this.units("si")}bends;root;bendList;colours;slider=I("input",{type:"range",min:0,max:v0,step:1,value:0,class:"view-thick"});units(e){let t=this.bends.map((i,s)=>I("option",{value:s},Cd(i,e)));this.bendList.replaceChildren(I("option",{value:""},"Bend\u2026"),...t)}coloured(e){this.colours.value=e}atBend(e){this.bendList.value=e===null?"":String(e)}},g0=n=>x0**((n-1)/(v0-1));var y0=[["Space","play, pause"],["\u2190 \u2192","frame by frame (Shift: ten)"],["Home End","first, last"],[", .","slower, faster"],["+ \u2212","zoom"],["W A S D","turn"],[`1\u2013${sc.length}`,"overview, along, plan, profile"],[`${Ea}\u20139`,"bends"],["B","next bend"],["E","next event"],["F","follow the head"],["C","next colour"],["Z","zoom to the place"],["Esc","clear the choice"]];function aM(n,e,t){let i=e?10:1,s=e?-1:1,r=/^[1-9]$/.test(n)?Number(n):0;return r>0&&r<=sc.length?()=>t.preset(r-1):r>=Ea&&r<Ea+_0?()=>t.bend(r-Ea):{" ":()=>t.toggle(),arrowleft:()=>t.step(-i),arrowright:()=>t.step(i),home:()=>t.end(!1),end:()=>t.end(!0),",":()=>t.faster(-1),".":()=>t.faster(1),"+":()=>t.zoom(1/1.3),"=":()=>t.zoom(1/1.3),"-":()=>t.zoom(1.3),w:()=>t.orbit(0,5),s:()=>t.orbit(0,-5),a:()=>t.orbit(-5,0),d:()=>t.orbit(5,0),b:()=>t.nextBend(s),e:()=>t.event(s),f:()=>t.follow(),c:()=>t.nextColour(),z:()=>t.toPlace(),escape:()=>t.leave()}[n.toLowerCase()]??null}function lM(n,e){return n instanceof HTMLSelectElement?e!=="Escape":n instanceof HTMLButtonElement?e===" "||e==="Enter":n instanceof HTMLInputElement?n.type==="checkbox"?e===" ":!n.classList.contains("view-time")&&/^(Arrow|Home|End)/.test(e):!1}function b0(n,e){let t=i=>{if(i.ctrlKey||i.metaKey||i.altKey||lM(i.target,i.key))return;let s=aM(i.key,i.shiftKey,e);s&&(i.preventDefault(),s())};return n.addEventListener("keydown",t),()=>n.removeEventListener("keydown",t)}var M0="force";async function S0(n){let e=n.roller_force,t=n.geometry?.rollers.length??0,i=n.states?.time_s??[];if(!e||t===0)return null;let s=new wa(i,t);return s.fields.set(M0,{meta:e,q:await Jl(e.packed,i.length,t,e.components)}),s}function cM(n,e){let t=n.series?.[`load_${e}_N`],i=n.series?.time_s;return!Array.isArray(t)||!Array.isArray(i)?null:{time:i.map(Number),values:t.map(s=>typeof s=="number"?s:NaN)}}var w0=(n,e)=>Float64Array.from(n,t=>t*e);function T0(n,e,t,i){let s=n.run.geometry?.rollers[e];if(!s)return null;let r=cM(n.run,s.name),o=r?.values??t?.history(M0,()=>e)??[],a=r?.time??t?.time??[],l=n.run.rollers,c=l?.name?.indexOf(s.name)??-1,u=p=>{let S=c>=0?l?.[p]?.[c]:null;return typeof S=="number"?S:null},d=u("peak_N"),h=[s.s_m===null?s.kind:`${s.kind} at ${Li(s.s_m,i)}`];for(let[p,S]of[["steady","steady_N"],["peak","peak_N"]]){let C=u(S);C!==null&&h.push(`${p} ${Ke(C,"N",i,3)}`)}s.rating_N!==null&&h.push(`may carry ${Ke(s.rating_N,"N",i,3)}`);let f=Array.from(o).reduce((p,S)=>S>p?S:p,d??0),{symbol:m,factor:v}=Gt("N",i,f),g=s.rating_N!==null&&s.rating_N<4*f?{label:"rating",value:s.rating_N*v}:void 0;return{title:s.name,facts:h,label:`load, ${m}`,time:a,values:w0(o,v),limit:g}}var uM=1.5;function E0(n,e,t,i,s){if(!n.path||!n.chain)return null;let r=n.chain.length_m.reduce((m,v)=>Math.max(m,v),0),o=t.segmentsAt(n.path.at(e),Math.max(1,uM*r)),a=t.frames.history(i.field,m=>Math.max(0,o[m])),l=a?a.map((m,v)=>o[v]<0?NaN:m):[],c=Array.from(l).filter(m=>Number.isFinite(m)),u=c.reduce((m,v)=>Math.max(m,v),-1/0),{symbol:d,factor:h}=Gt(i.unit,s,Math.max(Math.abs(u),0)),f=c.length>0?[]:["nothing passes there"];return c.length>0&&f.push(`largest ${Ke(u,i.unit,s,3)}`),{title:`Place ${Li(e,s)}`,facts:f,label:`${i.title.toLowerCase()}${d?`, ${d}`:""}`,time:t.frames.time,values:w0(l,h)}}function A0(n,e){let t=null,i=0,s=null,r=l=>{let c=n.getBoundingClientRect();return{x:l.clientX-c.left,y:l.clientY-c.top}},o=()=>{i=0,s&&e.hover(s.x,s.y)},a={pointerdown:l=>t=r(l),pointermove:l=>{s=l.buttons===0?r(l):null,i||=requestAnimationFrame(o)},pointerleave:()=>{s=null,e.leave()},click:l=>{let{x:c,y:u}=r(l);t&&Math.hypot(c-t.x,u-t.y)<4&&e.click(c,u)},dblclick:l=>{let{x:c,y:u}=r(l);e.double(c,u)}};for(let[l,c]of Object.entries(a))n.addEventListener(l,c);return()=>{cancelAnimationFrame(i);for(let[l,c]of Object.entries(a))n.removeEventListener(l,c)}}function C0(n,e,t){let i=n.headPlace(),s=n.largestTension,r=s?e.path?.nearest(n.centre(s.segment)):void 0,o=[`At ${Ta(n.time,n.frames.to)}`],a=[i===null?"the head is off the route":`the head is at ${Li(i,t)}`];if(s){let l=!r||r.distance>3?"off the route":`at ${Li(r.s,t)}`;a.push(`the largest tension is ${Ke(s.value,"N",t,3)} ${l}`)}return`${o.join("")} ${a.join(", ")}.`}var rc=class{constructor(e,t){this.visible=e;this.spoken=t}visible;spoken;timer=0;last=0;tell(e,t){let i=performance.now();(i-this.last>200||!t)&&(this.visible.textContent=e(),this.last=i),clearTimeout(this.timer),this.timer=window.setTimeout(()=>this.spoken.textContent=e(),hM)}dispose(){clearTimeout(this.timer)}},hM=700;var dM=1.5*Math.PI/180;function R0(n,e){let t=[],i=null;for(let s=0;s<n.length;s++){let r=Math.abs(e[s]??0);if(!(r>=.001&&s+1<n.length)){i&&i.angle>=dM&&t.push({...i,number:t.length+1}),i=null;continue}let a=Math.abs(e[s+1]??0),l=a>=.001?.5*(r+a):r;i??={number:0,from:n[s],to:n[s],radius:1/0,angle:0},i.to=n[s+1],i.angle+=l*(i.to-n[s]),i.radius=Math.min(i.radius,1/r)}return t}var P0=.05,I0=200;function fM(n){let e=n.chain?.segments??n.states?.segments??0;if(e===0)return null;let t=n.chain;return{segments:e,length_m:t?.length_m??new Array(e).fill(1),diameter_m:t?.diameter_m??new Array(e).fill(P0),part:t?.part??new Array(e).fill(0)}}function L0(n){let e=n.geometry??null,t=e?.route.position_m??[],i=d=>{let h=t.map(v=>v[d]),f=h.reduce((v,g)=>Math.min(v,g),1/0),m=h.reduce((v,g)=>Math.max(v,g),-1/0);return h.length>0?.5*(f+m):0},s=[i(0),i(1),i(2)],r=d=>Ft(d,s),o=t.map(r),a=fM(n),l=a?a.part.lastIndexOf(0):-1,c=Math.max(1,Math.floor(o.length/I0)),u=o.filter((d,h)=>h%c===0||h===o.length-1);return e?.reel&&u.push(r(e.reel.center_m)),e?.winch&&pM(o,r(e.winch.position_m))&&u.push(r(e.winch.position_m)),{run:n,centre:s,at:r,path:e&&o.length>1?new jl(e.route.s_m,o):null,bends:e?R0(e.route.s_m,e.route.curvature_per_m):[],chain:a,head:a?l>=0?l:a.segments-1:0,diameter:a?.diameter_m[Math.max(0,l)]??P0,extent:u}}function pM(n,e){let t=n[n.length-1];return!!t&&xi(Ft(e,t))<.5*xi(Ft(t,n[0]))}function N0(n,e){let t=n.fields.get("position");if(!t||e.path)return;let i=[];for(let r=0;r<n.items;r+=Math.max(1,Math.floor(n.items/I0)))i.push([0,1,2].map(o=>t.q[3*r+o]*t.meta.step));i.reduce((r,o)=>[r[0]+o[0],r[1]+o[1],r[2]+o[2]],[0,0,0]).forEach((r,o)=>e.centre[o]=r/i.length),e.extent=i.map(e.at)}function D0(n){let e=n.run.geometry?.reel;if(!e)return()=>!1;let[t,i,s]=n.at(e.center_m),[r,o,a]=Rd(e.axis);return(l,c,u)=>{let d=(l-t)*r+(c-i)*o+(u-s)*a,h=(l-t)**2+(c-i)**2+(u-s)**2-d*d;return Math.abs(d)<.6*e.width_m+.2&&h<(1.02*e.radius_m)**2}}var Rd=n=>dn(n,[0,1,0]);function F0(n,e,t=()=>!1){let i=n.fields.get(e);if(!i)return null;let{q:s,meta:r}=i,o=1/0,a=-1/0,l=p=>{for(let S=0;S<n.count;S++)for(let C=0;C<n.items;C++)t(C,S)||p(s[S*n.items+C])};if(l(p=>{p<o&&(o=p),p>a&&(a=p)}),o>a)return null;let c=new Uint32Array(2048),u=0,d=Math.max(1,a-o)/2047;l(p=>{c[Math.floor((p-o)/d)]++,u++});let h=0;for(let p=c[0];p<.998*u&&h<2047;)p+=c[++h];let f=o+(h+1)*d,m=a>0&&a-o>2*(f-o),v=Math.min(0,o)*r.step,g=(m?f:a)*r.step;return{low:v,high:g>v?g:v+r.step,beyond:m?a*r.step:null}}function oc(n,e,t){let i=(e-n)/Math.max(1,t);if(!(i>0))return[];let s=10**Math.floor(Math.log10(i)),r=s*([1,2,5,10].find(a=>a*s>=i)??10),o=[];for(let a=Math.ceil(n/r-1e-9)+0;a*r<=e*(1+1e-12)+1e-9*r;a++)o.push(a*r);return o}var ac=class{constructor(e){this.model=e;let t=e.run.states?.packed,i=Ad.filter(({field:s})=>t&&s in t);this.choices=i.length>0?i:Ad,this.quantity=this.choices[0]}model;choices;quantity;scales=new Map;choose(e){this.quantity=this.choices.find(t=>t.field===e)??this.quantity}get next(){return this.choices[(this.choices.indexOf(this.quantity)+1)%this.choices.length]}scale(e){let{field:t}=this.quantity;return e?.fields.has(t)&&!this.scales.has(t)&&this.scales.set(t,F0(e,t,this.wound(e))),this.scales.get(t)??null}wound(e){let t=e.fields.get("position");if(!this.model.run.geometry?.reel||!t)return;let i=D0(this.model),[s,r,o]=this.model.centre,{q:a,meta:l}=t;return(c,u)=>{let d=3*(u*e.items+c);return i(a[d]*l.step-s,a[d+1]*l.step-r,a[d+2]*l.step-o)}}};var mM=116,gM="11px system-ui",_M={light:{text:"#3b4650",grid:"#d9dfe5",line:"#1f6f8b",limit:"#c2410c"},dark:{text:"#c3ccd5",grid:"#2d3742",line:"#4fb3d4",limit:"#f08c4a"}},lc=class{constructor(e,t){this.seek=e;this.close=t}seek;close;root=I("section",{class:"view-inspector","aria-label":"Picked in the picture",hidden:!0});plot=null;time=NaN;show(e,t){if(this.plot?.destroy(),this.plot=null,this.root.hidden=!e,!e)return;let i=I("div",{class:"view-inspector-figure"});this.root.replaceChildren(I("header",{},I("strong",{},I("bdi",{},e.title.slice(0,80))),jn("\xD7",this.close,{"aria-label":"Close",title:"Close (Esc)"})),I("p",{},e.facts.join(" \xB7 ")),I("p",{class:"view-inspector-label"},`${e.label}, over time, s`),i),Array.from(e.values).some(r=>Number.isFinite(r))?this.plot=this.draw(i,e,t):i.append(I("p",{},"No figures over time in these data."))}draw(e,t,i){let s=_M[i],r={stroke:s.text,grid:{stroke:s.grid,width:1},ticks:{stroke:s.grid,width:1},font:gM},o=Array.from(t.values,u=>Number.isFinite(u)?u:null),a=[Array.from(t.time),o],l=[{},{label:t.label,stroke:s.line,width:1.5,points:{show:!1}}];t.limit&&(a.push(o.map(()=>t.limit?.value??null)),l.push({label:t.limit.label,stroke:s.limit,width:1,dash:[6,4],points:{show:!1}}));let c=new wn({width:Math.max(200,e.clientWidth),height:mM,legend:{show:!1},cursor:{drag:{x:!1,y:!1},y:!1},scales:{x:{time:!1}},axes:[{...r,size:20,gap:2},{...r,size:46}],series:l,hooks:{draw:[u=>this.line(u,s.limit)]}},a,e);return c.over.addEventListener("click",u=>this.seek(c.posToVal(u.offsetX,"x"))),c}line(e,t){if(!Number.isFinite(this.time))return;let i=e.valToPos(this.time,"x",!0);e.ctx.save(),e.ctx.strokeStyle=t,e.ctx.beginPath(),e.ctx.moveTo(i,e.bbox.top),e.ctx.lineTo(i,e.bbox.top+e.bbox.height),e.ctx.stroke(),e.ctx.restore()}at(e){this.time=e,this.plot?.redraw(!1,!1)}dispose(){this.plot?.destroy()}};var cc=[4456788,4725356,4665213,4277383,3757708,3238030,2783374,2328718,2070667,2271364,3520377,5555560,8048977,10869558,13820443,16639781];function xM(n){let e=cc.length-1,t=Math.min(1,Math.max(0,Number.isNaN(n)?0:n))*e,i=Math.min(e-1,Math.floor(t)),s=t-i,r=cc[i],o=cc[i+1],a=l=>{let c=r>>l&255;return c+s*((o>>l&255)-c)};return[a(16),a(8),a(0)]}function U0(n){let e=new Uint8Array(4*n);for(let t=0;t<n;t++)e.set([...xM(t/(n-1)).map(Math.round),255],4*t);return e}function O0(n){let e=cc.map(t=>`#${t.toString(16).padStart(6,"0")}`);return`linear-gradient(${n}, ${e.join(", ")})`}var uc=class{title=I("div",{class:"view-legend-title"});bar=I("div",{class:"view-legend-bar"});ticks=I("div",{class:"view-legend-ticks"});beyond=I("div",{class:"view-legend-note"});factor=I("div",{class:"view-legend-note"});grid=I("div",{class:"view-legend-note"});root;constructor(){this.bar.style.background=O0("to right");let e=I("div",{class:"view-legend-scale"},this.bar,this.ticks);this.root=I("div",{class:"view-legend"},this.title,e,this.beyond,this.factor,this.grid)}scale(e,t,i){if(this.bar.hidden=this.ticks.hidden=!t,this.beyond.textContent="",!t){this.title.textContent=`${e.title}: not in these data`;return}let{symbol:s,factor:r}=Gt(e.unit,i,t.high);this.title.textContent=`${e.title}, ${s}`;let o=t.low*r,a=t.high*r;this.ticks.replaceChildren(...oc(o,a,4).map(l=>{let c=I("span",{},hn(l,3));return c.style.left=`${100*(l-o)/(a-o)}%`,c})),t.beyond!==null&&(this.beyond.textContent=`single peaks to ${hn(t.beyond*r,3)} ${s} have the last colour`)}sizes(e,t,i){let s=e<10?e.toFixed(e<1.05?0:1).replace(".0",""):e.toFixed(0);this.factor.textContent=e<1.05?"true diameter":`diameter \xD7 ${s}, rollers and ducts with it`;let{symbol:r,factor:o}=Gt("m",i,t);this.grid.textContent=`grid ${hn(t*o,3)} ${r}`}};var B0=10,k0=40,vM=n=>n.length>k0?`${n.slice(0,k0)}\u2026`:n;function V0(n,e,t){let{path:i,run:s,bends:r}=e,o=s.geometry,a=(l,c,u,d,h="name")=>n.set(l,{text:c,point:u,weight:d,kind:h});if(i){let{factor:l}=Gt("m",t,1),c=oc(i.from*l,i.to*l,B0);for(let u=0;u<3*B0;u++){let d=(c[u]??0)/l,h=Li(d,t).replace(".0","");n.set(`distance${u}`,u<c.length?{text:h,point:i.at(d),weight:10,kind:"distance"}:null)}r.forEach((u,d)=>a(`bend${d}`,Cd(u,t),i.at(.5*(u.from+u.to)),20+u.angle));for(let u of o?.conveyors??[])a(`conveyor ${u.name}`,vM(u.name),i.at(.5*(u.from_m+u.to_m)),40)}o?.reel&&a("reel","Reel",e.at(o.reel.center_m),60),o?.winch&&a("winch","Winch",e.at(o.winch.position_m),60)}var hc=class{constructor(e,t){this.frames=e;this.model=t;this.centres=new Float32Array(3*e.items),this.values=new Float32Array(e.items),this.tension=new Float32Array(e.items)}frames;model;centres;values;tension;time=0;show(e,t){let i=this.frames.between(e);return this.frames.sample("position",i,this.centres,this.model.centre)?(this.frames.sample(t,i,this.values)||this.values.fill(0),this.frames.sample("tension",i,this.tension),this.time=e,!0):!1}centre(e){let t=this.centres;return[t[3*e],t[3*e+1],t[3*e+2]]}get largestTension(){if(!this.frames.fields.has("tension"))return null;let e=0;for(let t=1;t<this.tension.length;t++)this.tension[t]>this.tension[e]&&(e=t);return{segment:e,value:this.tension[e]}}headPlace(e=this.time){let t=this.model.run.states?.head_at_m??[],{frame:i,next:s,part:r}=this.frames.between(e),o=t[i]??null,a=t[s]??null;return o!==null&&a!==null?o+r*(a-o):this.model.path?.nearest(this.centre(this.model.head)).s??null}segmentsAt(e,t){let i=this.frames.fields.get("position"),s=new Int32Array(this.frames.count).fill(-1);if(!i)return s;let{q:r,meta:o}=i,[a,l,c]=e.map((d,h)=>(d+this.model.centre[h])/o.step),u=3*this.frames.items;for(let d=0;d<this.frames.count;d++){let h=(t/o.step)**2;for(let f=0,m=d*u;f<this.frames.items;f++,m+=3){let v=(r[m]-a)**2+(r[m+1]-l)**2+(r[m+2]-c)**2;v<h&&(h=v,s[d]=f)}}return s}};var vs=[.1,.25,.5,1,2,5,10,20,50,100,200,500,1e3],yM=25,bM=n=>vs.find(e=>e>=1&&n/e<=yM*1.2)??vs[vs.length-1],dc=class{constructor(e,t){this.from=e;this.to=t;this.time=e,this.rate=bM(t-e)}from;to;playing=!1;rate;time;seek(e){this.time=Math.min(this.to,Math.max(this.from,e))}toggle(){this.playing=!this.playing,this.playing&&this.time>=this.to&&(this.time=this.from)}advance(e){return this.playing?(this.seek(this.time+this.rate*Math.min(e,.25)),this.time>=this.to&&(this.playing=!1),!0):!1}};var Aa={play:"M4 2.5v11l9-5.5z",pause:"M4 3h3v10H4zM9 3h3v10H9z",before:"M3 3h2v10H3zM13 3v10L6 8z",next:"M11 3h2v10h-2zM3 3v10l7-5z"},z0=n=>it("svg",{width:14,height:14,viewBox:"0 0 16 16","aria-hidden":"true"},it("path",{d:n,fill:"currentColor"})),Pd=(n,e,t,i)=>I("button",{type:"button","aria-label":e,title:`${e} (${t})`,"aria-keyshortcuts":t,onclick:i},z0(n)),Id=4e3,fc=class{constructor(e,t,i){this.playback=e;this.play=Pd(Aa.play,"Play","Space",()=>i.toggle()),this.slider.setAttribute("aria-label","Simulated time"),this.slider.addEventListener("input",()=>i.seek(this.timeOf(this.slider.valueAsNumber))),this.followBox.addEventListener("change",()=>i.follow(this.followBox.checked));let s=this.rates=I("select",{title:"Simulated seconds a second"},...vs.map(a=>I("option",{value:a},`${a}\xD7`)));s.value=String(e.rate),s.addEventListener("change",()=>e.rate=Number(s.value));let r=I("select",{class:"view-jump","aria-label":"Jump to an event"},I("option",{value:""},"Jump to\u2026"),...t.map((a,l)=>I("option",{value:l},`${Ta(a.time_s,e.to)}  ${a.what.slice(0,80)}`)));r.addEventListener("change",()=>{let a=t[Number(r.value)];r.value&&a&&i.seek(a.time_s),r.value=""});let o=I("div",{class:"view-track"},this.slider,this.ticks(t));this.root=I("div",{class:"view-player"},this.play,Pd(Aa.before,"Event before","Shift+E",()=>i.event(-1)),Pd(Aa.next,"Next event","E",()=>i.event(1)),o,this.reading,I("label",{class:"view-field"},"Speed",s),r,I("label",{class:"view-field",title:"Camera goes with the head (F)"},this.followBox,"Follow head"))}playback;root;play;rates;slider=I("input",{type:"range",min:0,max:Id,step:"any",class:"view-time"});reading=I("output",{class:"view-reading"});followBox=I("input",{type:"checkbox"});timeOf(e){let{from:t,to:i}=this.playback;return t+(i-t)*e/Id}ticks(e){let{from:t,to:i}=this.playback;return I("div",{class:"view-ticks","aria-hidden":"true"},...e.map(s=>{let r=I("i");return r.style.left=`${100*(s.time_s-t)/Math.max(1e-9,i-t)}%`,r}))}update(){let{time:e,from:t,to:i,playing:s}=this.playback;this.slider.valueAsNumber=Id*(e-t)/Math.max(1e-9,i-t);let r=Ta(e,i);this.reading.textContent!==r&&(this.reading.textContent=r,this.slider.setAttribute("aria-valuetext",r));let o=s?"Pause":"Play";this.play.getAttribute("aria-label")!==o&&(this.play.replaceChildren(z0(s?Aa.pause:Aa.play)),this.play.setAttribute("aria-label",o))}following(e){this.followBox.checked=e}rated(){this.rates.value=String(this.playback.rate)}};var pc=class{constructor(e,t,i){this.store=t;this.narrator=i;this.model=L0(e),this.colouring=new ac(this.model);let s=e.states?.time_s??[];this.playback=new dc(s[0]??0,s[s.length-1]??0),this.events=(e.summary.events??[]).filter(r=>Number.isFinite(r.time_s)),this.inspector=new lc(r=>this.seek(r),()=>this.leave()),this.player=new fc(this.playback,this.events,this),this.tools=new ic(this.model.bends,this.colouring.choices,this)}store;narrator;model;playback;legend=new uc;inspector;player;tools;now=null;world=null;cameras=null;forces=null;colouring;events;stale=!0;choice=null;hovered=-1;request=0;draws(e,t){this.world=e,this.cameras=t,t.onChange=(i,s)=>{this.tools.atBend(i),this.player.following(s)},e.stage.onFrame=i=>this.tick(i)}arrived(e,t){t==="position"&&(this.now=new hc(e,this.model),N0(e,this.model),this.model.path||this.preset(0,!0)),t===this.colouring.quantity.field&&this.colour(t),this.refresh()}refresh(){this.stale=!0,this.world?this.world.stage.invalidate():this.request||=requestAnimationFrame(()=>this.unseen())}unseen(){this.request=0,this.tick(1/60)&&this.refresh()}tick(e){let{playback:t,now:i,world:s}=this;return t.advance(e)&&(this.stale=!0,this.store.set("time",t.time,this)),i&&this.stale&&i.show(t.time,this.colouring.quantity.field)&&this.cameras?.goWithHead(i),s?.update(this.stale?i:null),i&&this.stale&&this.tell(i),this.stale=!1,this.player.update(),s&&(s.updateLabels(),this.legend.sizes(s.factor,s.ground.spacing,this.store.get("units"))),t.playing}tell(e){let t=this.store.get("units"),i=this.world?.labels,s=e.largestTension;if(i?.set("head",{text:"Head",point:e.centre(this.model.head),weight:90,kind:"head"}),s&&i){let r=`Largest ${Ke(s.value,"N",t,3)}`;i.set("largest",{text:r,point:e.centre(s.segment),weight:95,kind:"largest"})}this.narrator.tell(()=>C0(e,this.model,t),this.playback.playing),this.inspector.at(e.time)}showAt(e){this.playback.seek(e),this.refresh()}seek(e){this.playback.seek(e),this.store.set("time",this.playback.time,this),this.refresh()}toggle(){this.playback.toggle(),this.refresh()}step(e){let t=this.now?.frames;if(!t)return;this.playback.playing=!1;let{frame:i,part:s}=t.between(this.playback.time),r=e<0&&s>1e-6?i+1:i;this.seek(t.time[Math.min(t.count-1,Math.max(0,r+e))])}end(e){this.seek(e?this.playback.to:this.playback.from)}faster(e){let t=vs.indexOf(this.playback.rate)+e;this.playback.rate=vs[Math.min(vs.length-1,Math.max(0,t))],this.player.rated()}event(e){let{time:t}=this.playback,i=this.events.map(r=>r.time_s).sort((r,o)=>r-o),s=e>0?i.find(r=>r>t+1e-6):i.filter(r=>r<t-1e-6).pop();s!==void 0&&this.seek(s)}zoom(e){this.world?.stage.zoom(e)}orbit(e,t){this.world?.stage.orbit(e,t)}factor(e){this.world?.exaggerate(e)}preset(e,t=!1){this.cameras?.preset(e,this.place,t)}bend(e){this.cameras?.bend(e)}nextBend(e){this.cameras?.nextBend(e)}follow(e){this.cameras?.follow(e)}toPlace(e=this.place){e!==null&&this.model.path&&this.cameras?.lookAt(this.model.path.at(e))}colour(e){let{colouring:t}=this;t.choose(e);let i=t.scale(this.now?.frames);this.tools.coloured(e),this.world?.scale(i),this.legend.scale(t.quantity,i,this.store.get("units")),this.choice&&"place"in this.choice&&this.inspect(this.choice),this.refresh()}nextColour(){this.colour(this.colouring.next.field)}get place(){return this.store.get("place")??(this.choice&&"place"in this.choice?this.choice.place:null)}inspect(e){this.choice=e;let{model:t,now:i}=this,s=this.store.get("units"),r=e&&"roller"in e?e.roller:null;this.store.set("roller",r,this);let o=e&&"place"in e&&i,a=r!==null?T0(t,r,this.forces,s):o?E0(t,e.place,i,this.colouring.quantity,s):null;this.inspector.show(a,this.store.get("theme")),this.world?.rollers?.mark(r??-1,-1),this.mark()}inspectAgain(){this.choice&&this.inspect(this.choice)}leave(){this.inspect(null)}hover(e){this.hovered=e,this.mark()}mark(){let{model:e,world:t,place:i,hovered:s}=this,r=e.run.geometry?.rollers[s]?.name.slice(0,60),o=i===null?"":Li(i,this.store.get("units")),a=r?t?.rollers?.centre(s):i===null?void 0:e.path?.at(i),l=[r,o].filter(Boolean).join(" \xB7 ");t?.labels.set("place",a?{text:l,point:a,weight:200,kind:"place"}:null),t?.stage.invalidate()}redress(){let e=this.store.get("units");this.tools.units(e),this.world&&(V0(this.world.labels,this.model,e),this.world.unit=1/Gt("m",e,1).factor,this.world.paint(this.store.get("theme"))),this.colour(this.colouring.quantity.field),this.inspectAgain(),this.mark()}dispose(){cancelAnimationFrame(this.request),this.narrator.dispose(),this.inspector.dispose(),this.world?.dispose()}};var ar={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},lr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},c_=0,cf=1,u_=2;var nl=1,h_=2,Ho=3,$i=0,ti=1,ai=2,cs=0,Ur=1,uf=2,hf=3,df=4,d_=5;var er=100,f_=101,p_=102,m_=103,g_=104,__=200,x_=201,v_=202,y_=203,Bc=204,kc=205,b_=206,M_=207,S_=208,w_=209,T_=210,E_=211,A_=212,C_=213,R_=214,Vc=0,zc=1,Gc=2,Or=3,Hc=4,Wc=5,Xc=6,qc=7,ff=0,P_=1,I_=2,Ki=0,pf=1,mf=2,gf=3,_f=4,xf=5,vf=6,yf=7;var bf=300,cr=301,Gr=302,_u=303,xu=304,il=306,Yc=1e3,as=1001,$c=1002,vn=1003,L_=1004;var sl=1005;var En=1006,vu=1007;var ur=1008;var Ti=1009,Mf=1010,Sf=1011,Wo=1012,yu=1013,Ji=1014,Ei=1015,us=1016,bu=1017,Mu=1018,Xo=1020,wf=35902,Tf=35899,Ef=1021,Af=1022,ni=1023,ls=1026,hr=1027,Cf=1028,Su=1029,dr=1030,wu=1031;var Tu=1033,rl=33776,ol=33777,al=33778,ll=33779,Eu=35840,Au=35841,Cu=35842,Ru=35843,Pu=36196,Iu=37492,Lu=37496,Nu=37488,Du=37489,cl=37490,Fu=37491,Uu=37808,Ou=37809,Bu=37810,ku=37811,Vu=37812,zu=37813,Gu=37814,Hu=37815,Wu=37816,Xu=37817,qu=37818,Yu=37819,$u=37820,Zu=37821,Ku=36492,Ju=36494,ju=36495,Qu=36283,eh=36284,ul=36285,th=36286;var Fa=2300,Zc=2301,Oc=2302,ef=2303,tf=2400,nf=2401,sf=2402;var N_=3200;var Rf=0,D_=1,Ps="",bi="srgb",Ua="srgb-linear",Oa="linear",Pt="srgb";var Dr=7680;var rf=519,F_=512,U_=513,O_=514,nh=515,B_=516,k_=517,ih=518,V_=519,of=35044;var Pf="300 es",Yi=2e3,Ba=2001;function MM(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function SM(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ka(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function z_(){let n=ka("canvas");return n.style.display="block",n}var G0={},Uo=null;function If(...n){let e="THREE."+n.shift();Uo?Uo("log",e,...n):console.log(e,...n)}function G_(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ye(...n){n=G_(n);let e="THREE."+n.shift();if(Uo)Uo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function Je(...n){n=G_(n);let e="THREE."+n.shift();if(Uo)Uo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Fr(...n){let e=n.join(" ");e in G0||(G0[e]=!0,Ye(...n))}function H_(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var W_={[Vc]:zc,[Gc]:Xc,[Hc]:qc,[Or]:Wc,[zc]:Vc,[Xc]:Gc,[qc]:Hc,[Wc]:Or},Zi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Vn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],H0=1234567,Na=Math.PI/180,Oo=180/Math.PI;function qo(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Vn[n&255]+Vn[n>>8&255]+Vn[n>>16&255]+Vn[n>>24&255]+"-"+Vn[e&255]+Vn[e>>8&255]+"-"+Vn[e>>16&15|64]+Vn[e>>24&255]+"-"+Vn[t&63|128]+Vn[t>>8&255]+"-"+Vn[t>>16&255]+Vn[t>>24&255]+Vn[i&255]+Vn[i>>8&255]+Vn[i>>16&255]+Vn[i>>24&255]).toLowerCase()}function ut(n,e,t){return Math.max(e,Math.min(t,n))}function Lf(n,e){return(n%e+e)%e}function wM(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function TM(n,e,t){return n!==e?(t-n)/(e-n):0}function Da(n,e,t){return(1-t)*n+t*e}function EM(n,e,t,i){return Da(n,e,1-Math.exp(-t*i))}function AM(n,e=1){return e-Math.abs(Lf(n,e*2)-e)}function CM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function RM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function PM(n,e){return n+Math.floor(Math.random()*(e-n+1))}function IM(n,e){return n+Math.random()*(e-n)}function LM(n){return n*(.5-Math.random())}function NM(n){n!==void 0&&(H0=n);let e=H0+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function DM(n){return n*Na}function FM(n){return n*Oo}function UM(n){return(n&n-1)===0&&n!==0}function OM(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function BM(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function kM(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),d=r((e-i)/2),h=o((e-i)/2),f=r((i-e)/2),m=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*d,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*d,a*c);break;case"ZXZ":n.set(l*d,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*m,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*m,a*c);break;case"ZYZ":n.set(l*m,l*f,a*u,a*c);break;default:Ye("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Do(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("THREE.MathUtils: Invalid component type.")}}function ei(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("THREE.MathUtils: Invalid component type.")}}var Nf={DEG2RAD:Na,RAD2DEG:Oo,generateUUID:qo,clamp:ut,euclideanModulo:Lf,mapLinear:wM,inverseLerp:TM,lerp:Da,damp:EM,pingpong:AM,smoothstep:CM,smootherstep:RM,randInt:PM,randFloat:IM,randFloatSpread:LM,seededRandom:NM,degToRad:DM,radToDeg:FM,isPowerOfTwo:UM,ceilPowerOfTwo:OM,floorPowerOfTwo:BM,setQuaternionFromProperEuler:kM,normalize:ei,denormalize:Do},je=class n{static{n.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ut(this.x,e.x,t.x),this.y=ut(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ut(this.x,e,t),this.y=ut(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ut(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ut(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Hn=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],d=i[s+3],h=r[o+0],f=r[o+1],m=r[o+2],v=r[o+3];if(d!==v||l!==h||c!==f||u!==m){let g=l*h+c*f+u*m+d*v;g<0&&(h=-h,f=-f,m=-m,v=-v,g=-g);let p=1-a;if(g<.9995){let S=Math.acos(g),C=Math.sin(S);p=Math.sin(p*S)/C,a=Math.sin(a*S)/C,l=l*p+h*a,c=c*p+f*a,u=u*p+m*a,d=d*p+v*a}else{l=l*p+h*a,c=c*p+f*a,u=u*p+m*a,d=d*p+v*a;let S=1/Math.sqrt(l*l+c*c+u*u+d*d);l*=S,c*=S,u*=S,d*=S}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=d}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],d=r[o],h=r[o+1],f=r[o+2],m=r[o+3];return e[t]=a*m+u*d+l*f-c*h,e[t+1]=l*m+u*h+c*d-a*f,e[t+2]=c*m+u*f+a*h-l*d,e[t+3]=u*m-a*d-l*h-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),d=a(r/2),h=l(i/2),f=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=h*u*d+c*f*m,this._y=c*f*d-h*u*m,this._z=c*u*m+h*f*d,this._w=c*u*d-h*f*m;break;case"YXZ":this._x=h*u*d+c*f*m,this._y=c*f*d-h*u*m,this._z=c*u*m-h*f*d,this._w=c*u*d+h*f*m;break;case"ZXY":this._x=h*u*d-c*f*m,this._y=c*f*d+h*u*m,this._z=c*u*m+h*f*d,this._w=c*u*d-h*f*m;break;case"ZYX":this._x=h*u*d-c*f*m,this._y=c*f*d+h*u*m,this._z=c*u*m-h*f*d,this._w=c*u*d+h*f*m;break;case"YZX":this._x=h*u*d+c*f*m,this._y=c*f*d+h*u*m,this._z=c*u*m-h*f*d,this._w=c*u*d-h*f*m;break;case"XZY":this._x=h*u*d-c*f*m,this._y=c*f*d-h*u*m,this._z=c*u*m+h*f*d,this._w=c*u*d+h*f*m;break;default:Ye("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],d=t[10],h=i+a+d;if(h>0){let f=.5/Math.sqrt(h+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>d){let f=2*Math.sqrt(1+i-a-d);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>d){let f=2*Math.sqrt(1+a-i-d);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+d-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ut(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},z=class n{static{n.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(W0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(W0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),d=2*(r*i-o*t);return this.x=t+l*c+o*d-a*u,this.y=i+l*u+a*c-r*d,this.z=s+l*d+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ut(this.x,e.x,t.x),this.y=ut(this.y,e.y,t.y),this.z=ut(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ut(this.x,e,t),this.y=ut(this.y,e,t),this.z=ut(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ut(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Ld.copy(this).projectOnVector(e),this.sub(Ld)}reflect(e){return this.sub(Ld.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ut(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Ld=new z,W0=new Hn,nt=class n{static{n.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],d=i[7],h=i[2],f=i[5],m=i[8],v=s[0],g=s[3],p=s[6],S=s[1],C=s[4],b=s[7],E=s[2],T=s[5],D=s[8];return r[0]=o*v+a*S+l*E,r[3]=o*g+a*C+l*T,r[6]=o*p+a*b+l*D,r[1]=c*v+u*S+d*E,r[4]=c*g+u*C+d*T,r[7]=c*p+u*b+d*D,r[2]=h*v+f*S+m*E,r[5]=h*g+f*C+m*T,r[8]=h*p+f*b+m*D,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],d=u*o-a*c,h=a*l-u*r,f=c*r-o*l,m=t*d+i*h+s*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/m;return e[0]=d*v,e[1]=(s*c-u*i)*v,e[2]=(a*i-s*o)*v,e[3]=h*v,e[4]=(u*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=f*v,e[7]=(i*l-c*t)*v,e[8]=(o*t-i*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Fr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Nd.makeScale(e,t)),this}rotate(e){return Fr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Nd.makeRotation(-e)),this}translate(e,t){return Fr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Nd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Nd=new nt,X0=new nt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),q0=new nt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function VM(){let n={enabled:!0,workingColorSpace:Ua,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pt&&(s.r=Es(s.r),s.g=Es(s.g),s.b=Es(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(s.r=Fo(s.r),s.g=Fo(s.g),s.b=Fo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ps?Oa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return Fr("ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),n.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return Fr("ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),n.colorSpaceToWorking(s,r)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ua]:{primaries:e,whitePoint:i,transfer:Oa,toXYZ:X0,fromXYZ:q0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:bi},outputColorSpaceConfig:{drawingBufferColorSpace:bi}},[bi]:{primaries:e,whitePoint:i,transfer:Pt,toXYZ:X0,fromXYZ:q0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:bi}}}),n}var _t=VM();function Es(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Fo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Mo,Kc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Mo===void 0&&(Mo=ka("canvas")),Mo.width=e.width,Mo.height=e.height;let s=Mo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Mo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=ka("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Es(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Es(t[i]/255)*255):t[i]=Es(t[i]);return{data:t,width:e.width,height:e.height}}else return Ye("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},zM=0,Bo=class{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:zM++}),this.uuid=qo(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Dd(s[o].image)):r.push(Dd(s[o]))}else r=Dd(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Dd(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Kc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ye("Texture: Unable to serialize Texture."),{})}var GM=0,Fd=new z,oi=class n extends Zi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=as,s=as,r=En,o=ur,a=ni,l=Ti,c=n.DEFAULT_ANISOTROPY,u=Ps){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:GM++}),this.uuid=qo(),this.name="",this.source=new Bo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new je(0,0),this.repeat=new je(1,1),this.center=new je(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new nt,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.normalized=!1}get width(){return this.source.getSize(Fd).x}get height(){return this.source.getSize(Fd).y}get depth(){return this.source.getSize(Fd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ye(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==bf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Yc:e.x=e.x-Math.floor(e.x);break;case as:e.x=e.x<0?0:1;break;case $c:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Yc:e.y=e.y-Math.floor(e.y);break;case as:e.y=e.y<0?0:1;break;case $c:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};oi.DEFAULT_IMAGE=null;oi.DEFAULT_MAPPING=bf;oi.DEFAULT_ANISOTROPY=1;var jt=class n{static{n.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],d=l[8],h=l[1],f=l[5],m=l[9],v=l[2],g=l[6],p=l[10];if(Math.abs(u-h)<.01&&Math.abs(d-v)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+h)<.1&&Math.abs(d+v)<.1&&Math.abs(m+g)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let C=(c+1)/2,b=(f+1)/2,E=(p+1)/2,T=(u+h)/4,D=(d+v)/4,y=(m+g)/4;return C>b&&C>E?C<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(C),s=T/i,r=D/i):b>E?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=T/s,r=y/s):E<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(E),i=D/r,s=y/r),this.set(i,s,r,t),this}let S=Math.sqrt((g-m)*(g-m)+(d-v)*(d-v)+(h-u)*(h-u));return Math.abs(S)<.001&&(S=1),this.x=(g-m)/S,this.y=(d-v)/S,this.z=(h-u)/S,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ut(this.x,e.x,t.x),this.y=ut(this.y,e.y,t.y),this.z=ut(this.z,e.z,t.z),this.w=ut(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ut(this.x,e,t),this.y=ut(this.y,e,t),this.z=ut(this.z,e,t),this.w=ut(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ut(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Jc=class extends Zi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:En,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new jt(0,0,e,t),this.scissorTest=!1,this.viewport=new jt(0,0,e,t),this.textures=[];let s={width:e,height:t,depth:i.depth},r=new oi(s),o=i.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:En,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Bo(s)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Mi=class extends Jc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Va=class extends oi{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=vn,this.minFilter=vn,this.wrapR=as,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var jc=class extends oi{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=vn,this.minFilter=vn,this.wrapR=as,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Vt=class n{static{n.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,d,h,f,m,v,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,d,h,f,m,v,g)}set(e,t,i,s,r,o,a,l,c,u,d,h,f,m,v,g){let p=this.elements;return p[0]=e,p[4]=t,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=d,p[14]=h,p[3]=f,p[7]=m,p[11]=v,p[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/So.setFromMatrixColumn(e,0).length(),r=1/So.setFromMatrixColumn(e,1).length(),o=1/So.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let h=o*u,f=o*d,m=a*u,v=a*d;t[0]=l*u,t[4]=-l*d,t[8]=c,t[1]=f+m*c,t[5]=h-v*c,t[9]=-a*l,t[2]=v-h*c,t[6]=m+f*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,f=l*d,m=c*u,v=c*d;t[0]=h+v*a,t[4]=m*a-f,t[8]=o*c,t[1]=o*d,t[5]=o*u,t[9]=-a,t[2]=f*a-m,t[6]=v+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,f=l*d,m=c*u,v=c*d;t[0]=h-v*a,t[4]=-o*d,t[8]=m+f*a,t[1]=f+m*a,t[5]=o*u,t[9]=v-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,f=o*d,m=a*u,v=a*d;t[0]=l*u,t[4]=m*c-f,t[8]=h*c+v,t[1]=l*d,t[5]=v*c+h,t[9]=f*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,f=o*c,m=a*l,v=a*c;t[0]=l*u,t[4]=v-h*d,t[8]=m*d+f,t[1]=d,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*d+m,t[10]=h-v*d}else if(e.order==="XZY"){let h=o*l,f=o*c,m=a*l,v=a*c;t[0]=l*u,t[4]=-d,t[8]=c*u,t[1]=h*d+v,t[5]=o*u,t[9]=f*d-m,t[2]=m*d-f,t[6]=a*u,t[10]=v*d+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(HM,e,WM)}lookAt(e,t,i){let s=this.elements;return vi.subVectors(e,t),vi.lengthSq()===0&&(vi.z=1),vi.normalize(),Ys.crossVectors(i,vi),Ys.lengthSq()===0&&(Math.abs(i.z)===1?vi.x+=1e-4:vi.z+=1e-4,vi.normalize(),Ys.crossVectors(i,vi)),Ys.normalize(),mc.crossVectors(vi,Ys),s[0]=Ys.x,s[4]=mc.x,s[8]=vi.x,s[1]=Ys.y,s[5]=mc.y,s[9]=vi.y,s[2]=Ys.z,s[6]=mc.z,s[10]=vi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],d=i[5],h=i[9],f=i[13],m=i[2],v=i[6],g=i[10],p=i[14],S=i[3],C=i[7],b=i[11],E=i[15],T=s[0],D=s[4],y=s[8],A=s[12],F=s[1],L=s[5],U=s[9],G=s[13],q=s[2],O=s[6],Y=s[10],H=s[14],ie=s[3],oe=s[7],le=s[11],de=s[15];return r[0]=o*T+a*F+l*q+c*ie,r[4]=o*D+a*L+l*O+c*oe,r[8]=o*y+a*U+l*Y+c*le,r[12]=o*A+a*G+l*H+c*de,r[1]=u*T+d*F+h*q+f*ie,r[5]=u*D+d*L+h*O+f*oe,r[9]=u*y+d*U+h*Y+f*le,r[13]=u*A+d*G+h*H+f*de,r[2]=m*T+v*F+g*q+p*ie,r[6]=m*D+v*L+g*O+p*oe,r[10]=m*y+v*U+g*Y+p*le,r[14]=m*A+v*G+g*H+p*de,r[3]=S*T+C*F+b*q+E*ie,r[7]=S*D+C*L+b*O+E*oe,r[11]=S*y+C*U+b*Y+E*le,r[15]=S*A+C*G+b*H+E*de,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],d=e[6],h=e[10],f=e[14],m=e[3],v=e[7],g=e[11],p=e[15],S=l*f-c*h,C=a*f-c*d,b=a*h-l*d,E=o*f-c*u,T=o*h-l*u,D=o*d-a*u;return t*(v*S-g*C+p*b)-i*(m*S-g*E+p*T)+s*(m*C-v*E+p*D)-r*(m*b-v*T+g*D)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],d=e[9],h=e[10],f=e[11],m=e[12],v=e[13],g=e[14],p=e[15],S=t*a-i*o,C=t*l-s*o,b=t*c-r*o,E=i*l-s*a,T=i*c-r*a,D=s*c-r*l,y=u*v-d*m,A=u*g-h*m,F=u*p-f*m,L=d*g-h*v,U=d*p-f*v,G=h*p-f*g,q=S*G-C*U+b*L+E*F-T*A+D*y;if(q===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let O=1/q;return e[0]=(a*G-l*U+c*L)*O,e[1]=(s*U-i*G-r*L)*O,e[2]=(v*D-g*T+p*E)*O,e[3]=(h*T-d*D-f*E)*O,e[4]=(l*F-o*G-c*A)*O,e[5]=(t*G-s*F+r*A)*O,e[6]=(g*b-m*D-p*C)*O,e[7]=(u*D-h*b+f*C)*O,e[8]=(o*U-a*F+c*y)*O,e[9]=(i*F-t*U-r*y)*O,e[10]=(m*T-v*b+p*S)*O,e[11]=(d*b-u*T-f*S)*O,e[12]=(a*A-o*L-l*y)*O,e[13]=(t*L-i*A+s*y)*O,e[14]=(v*C-m*E-g*S)*O,e[15]=(u*E-d*C+h*S)*O,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,d=a+a,h=r*c,f=r*u,m=r*d,v=o*u,g=o*d,p=a*d,S=l*c,C=l*u,b=l*d,E=i.x,T=i.y,D=i.z;return s[0]=(1-(v+p))*E,s[1]=(f+b)*E,s[2]=(m-C)*E,s[3]=0,s[4]=(f-b)*T,s[5]=(1-(h+p))*T,s[6]=(g+S)*T,s[7]=0,s[8]=(m+C)*D,s[9]=(g-S)*D,s[10]=(1-(h+v))*D,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=So.set(s[0],s[1],s[2]).length(),a=So.set(s[4],s[5],s[6]).length(),l=So.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Wi.copy(this);let c=1/o,u=1/a,d=1/l;return Wi.elements[0]*=c,Wi.elements[1]*=c,Wi.elements[2]*=c,Wi.elements[4]*=u,Wi.elements[5]*=u,Wi.elements[6]*=u,Wi.elements[8]*=d,Wi.elements[9]*=d,Wi.elements[10]*=d,t.setFromRotationMatrix(Wi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Yi,l=!1){let c=this.elements,u=2*r/(t-e),d=2*r/(i-s),h=(t+e)/(t-e),f=(i+s)/(i-s),m,v;if(l)m=r/(o-r),v=o*r/(o-r);else if(a===Yi)m=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===Ba)m=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Yi,l=!1){let c=this.elements,u=2/(t-e),d=2/(i-s),h=-(t+e)/(t-e),f=-(i+s)/(i-s),m,v;if(l)m=1/(o-r),v=o/(o-r);else if(a===Yi)m=-2/(o-r),v=-(o+r)/(o-r);else if(a===Ba)m=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=m,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},So=new z,Wi=new Vt,HM=new z(0,0,0),WM=new z(1,1,1),Ys=new z,mc=new z,vi=new z,Y0=new Vt,$0=new Hn,tr=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],d=s[2],h=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(ut(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ut(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(ut(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ut(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(h,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ut(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ut(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Ye("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Y0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Y0,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return $0.setFromEuler(this),this.setFromQuaternion($0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};tr.DEFAULT_ORDER="XYZ";var za=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},XM=0,Z0=new z,wo=new Hn,ys=new Vt,gc=new z,Ca=new z,qM=new z,YM=new Hn,K0=new z(1,0,0),J0=new z(0,1,0),j0=new z(0,0,1),Q0={type:"added"},$M={type:"removed"},To={type:"childadded",child:null},Ud={type:"childremoved",child:null},Si=class n extends Zi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:XM++}),this.uuid=qo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new z,t=new tr,i=new Hn,s=new z(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Vt},normalMatrix:{value:new nt}}),this.matrix=new Vt,this.matrixWorld=new Vt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new za,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return wo.setFromAxisAngle(e,t),this.quaternion.multiply(wo),this}rotateOnWorldAxis(e,t){return wo.setFromAxisAngle(e,t),this.quaternion.premultiply(wo),this}rotateX(e){return this.rotateOnAxis(K0,e)}rotateY(e){return this.rotateOnAxis(J0,e)}rotateZ(e){return this.rotateOnAxis(j0,e)}translateOnAxis(e,t){return Z0.copy(e).applyQuaternion(this.quaternion),this.position.add(Z0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(K0,e)}translateY(e){return this.translateOnAxis(J0,e)}translateZ(e){return this.translateOnAxis(j0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ys.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?gc.copy(e):gc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Ca.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ys.lookAt(Ca,gc,this.up):ys.lookAt(gc,Ca,this.up),this.quaternion.setFromRotationMatrix(ys),s&&(ys.extractRotation(s.matrixWorld),wo.setFromRotationMatrix(ys),this.quaternion.premultiply(wo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Je("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Q0),To.child=e,this.dispatchEvent(To),To.child=null):Je("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent($M),Ud.child=e,this.dispatchEvent(Ud),Ud.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ys.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ys.multiply(e.parent.matrixWorld)),e.applyMatrix4(ys),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Q0),To.child=e,this.dispatchEvent(To),To.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ca,e,qM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ca,YM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),this.static!==!1&&(s.static=this.static),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let d=l[c];r(e.shapes,d)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),d=o(e.shapes),h=o(e.skeletons),f=o(e.animations),m=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),d.length>0&&(i.shapes=d),h.length>0&&(i.skeletons=h),f.length>0&&(i.animations=f),m.length>0&&(i.nodes=m)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}};Si.DEFAULT_UP=new z(0,1,0);Si.DEFAULT_MATRIX_AUTO_UPDATE=!0;Si.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ts=class extends Si{constructor(){super(),this.isGroup=!0,this.type="Group"}},ZM={type:"move"},ko=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ts,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ts,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ts,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new z,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let g=t.getJointPose(v,i),p=this._getHandJoint(c,v);g!==null&&(p.matrix.fromArray(g.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=g.radius),p.visible=g!==null}let u=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],h=u.position.distanceTo(d.position),f=.02,m=.005;c.inputState.pinching&&h>f+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=f-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(ZM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Ts;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},X_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},$s={h:0,s:0,l:0},_c={h:0,s:0,l:0};function Od(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var xt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=bi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,_t.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=_t.workingColorSpace){return this.r=e,this.g=t,this.b=i,_t.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=_t.workingColorSpace){if(e=Lf(e,1),t=ut(t,0,1),i=ut(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Od(o,r,e+1/3),this.g=Od(o,r,e),this.b=Od(o,r,e-1/3)}return _t.colorSpaceToWorking(this,s),this}setStyle(e,t=bi){function i(r){r!==void 0&&parseFloat(r)<1&&Ye("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ye("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ye("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=bi){let i=X_[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ye("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Es(e.r),this.g=Es(e.g),this.b=Es(e.b),this}copyLinearToSRGB(e){return this.r=Fo(e.r),this.g=Fo(e.g),this.b=Fo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=bi){return _t.workingToColorSpace(zn.copy(this),e),Math.round(ut(zn.r*255,0,255))*65536+Math.round(ut(zn.g*255,0,255))*256+Math.round(ut(zn.b*255,0,255))}getHexString(e=bi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=_t.workingColorSpace){_t.workingToColorSpace(zn.copy(this),t);let i=zn.r,s=zn.g,r=zn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=u<=.5?d/(o+a):d/(2-o-a),o){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=_t.workingColorSpace){return _t.workingToColorSpace(zn.copy(this),t),e.r=zn.r,e.g=zn.g,e.b=zn.b,e}getStyle(e=bi){_t.workingToColorSpace(zn.copy(this),e);let t=zn.r,i=zn.g,s=zn.b;return e!==bi?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL($s),this.setHSL($s.h+e,$s.s+t,$s.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL($s),e.getHSL(_c);let i=Da($s.h,_c.h,t),s=Da($s.s,_c.s,t),r=Da($s.l,_c.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},zn=new xt;xt.NAMES=X_;var Ga=class extends Si{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new tr,this.environmentIntensity=1,this.environmentRotation=new tr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}},Xi=new z,bs=new z,Bd=new z,Ms=new z,Eo=new z,Ao=new z,e_=new z,kd=new z,Vd=new z,zd=new z,Gd=new jt,Hd=new jt,Wd=new jt,Qs=class n{constructor(e=new z,t=new z,i=new z){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Xi.subVectors(e,t),s.cross(Xi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Xi.subVectors(s,t),bs.subVectors(i,t),Bd.subVectors(e,t);let o=Xi.dot(Xi),a=Xi.dot(bs),l=Xi.dot(Bd),c=bs.dot(bs),u=bs.dot(Bd),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let h=1/d,f=(c*l-a*u)*h,m=(o*u-a*l)*h;return r.set(1-f-m,m,f)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Ms)===null?!1:Ms.x>=0&&Ms.y>=0&&Ms.x+Ms.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Ms)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ms.x),l.addScaledVector(o,Ms.y),l.addScaledVector(a,Ms.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return Gd.setScalar(0),Hd.setScalar(0),Wd.setScalar(0),Gd.fromBufferAttribute(e,t),Hd.fromBufferAttribute(e,i),Wd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Gd,r.x),o.addScaledVector(Hd,r.y),o.addScaledVector(Wd,r.z),o}static isFrontFacing(e,t,i,s){return Xi.subVectors(i,t),bs.subVectors(e,t),Xi.cross(bs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Xi.subVectors(this.c,this.b),bs.subVectors(this.a,this.b),Xi.cross(bs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Eo.subVectors(s,i),Ao.subVectors(r,i),kd.subVectors(e,i);let l=Eo.dot(kd),c=Ao.dot(kd);if(l<=0&&c<=0)return t.copy(i);Vd.subVectors(e,s);let u=Eo.dot(Vd),d=Ao.dot(Vd);if(u>=0&&d<=u)return t.copy(s);let h=l*d-u*c;if(h<=0&&l>=0&&u<=0)return o=l/(l-u),t.copy(i).addScaledVector(Eo,o);zd.subVectors(e,r);let f=Eo.dot(zd),m=Ao.dot(zd);if(m>=0&&f<=m)return t.copy(r);let v=f*c-l*m;if(v<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(i).addScaledVector(Ao,a);let g=u*m-f*d;if(g<=0&&d-u>=0&&f-m>=0)return e_.subVectors(r,s),a=(d-u)/(d-u+(f-m)),t.copy(s).addScaledVector(e_,a);let p=1/(g+v+h);return o=v*p,a=h*p,t.copy(i).addScaledVector(Eo,o).addScaledVector(Ao,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},nr=class{constructor(e=new z(1/0,1/0,1/0),t=new z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(qi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(qi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=qi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,qi):qi.fromBufferAttribute(r,o),qi.applyMatrix4(e.matrixWorld),this.expandByPoint(qi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),xc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),xc.copy(i.boundingBox)),xc.applyMatrix4(e.matrixWorld),this.union(xc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,qi),qi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ra),vc.subVectors(this.max,Ra),Co.subVectors(e.a,Ra),Ro.subVectors(e.b,Ra),Po.subVectors(e.c,Ra),Zs.subVectors(Ro,Co),Ks.subVectors(Po,Ro),Pr.subVectors(Co,Po);let t=[0,-Zs.z,Zs.y,0,-Ks.z,Ks.y,0,-Pr.z,Pr.y,Zs.z,0,-Zs.x,Ks.z,0,-Ks.x,Pr.z,0,-Pr.x,-Zs.y,Zs.x,0,-Ks.y,Ks.x,0,-Pr.y,Pr.x,0];return!Xd(t,Co,Ro,Po,vc)||(t=[1,0,0,0,1,0,0,0,1],!Xd(t,Co,Ro,Po,vc))?!1:(yc.crossVectors(Zs,Ks),t=[yc.x,yc.y,yc.z],Xd(t,Co,Ro,Po,vc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,qi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(qi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ss[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ss[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ss[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ss[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ss[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ss[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ss[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ss[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ss),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Ss=[new z,new z,new z,new z,new z,new z,new z,new z],qi=new z,xc=new nr,Co=new z,Ro=new z,Po=new z,Zs=new z,Ks=new z,Pr=new z,Ra=new z,vc=new z,yc=new z,Ir=new z;function Xd(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Ir.fromArray(n,r);let a=s.x*Math.abs(Ir.x)+s.y*Math.abs(Ir.y)+s.z*Math.abs(Ir.z),l=e.dot(Ir),c=t.dot(Ir),u=i.dot(Ir);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var xn=new z,bc=new je,KM=0,ri=class extends Zi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:KM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=of,this.updateRanges=[],this.gpuType=Ei,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)bc.fromBufferAttribute(this,t),bc.applyMatrix3(e),this.setXY(t,bc.x,bc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix3(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix4(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyNormalMatrix(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.transformDirection(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=Do(i,this.array)),i}setComponent(e,t,i){return this.normalized&&(i=ei(i,this.array)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=Do(t,this.array)),t}setX(e,t){return this.normalized&&(t=ei(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=Do(t,this.array)),t}setY(e,t){return this.normalized&&(t=ei(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=Do(t,this.array)),t}setZ(e,t){return this.normalized&&(t=ei(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=Do(t,this.array)),t}setW(e,t){return this.normalized&&(t=ei(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=ei(t,this.array),i=ei(i,this.array)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=ei(t,this.array),i=ei(i,this.array),s=ei(s,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=ei(t,this.array),i=ei(i,this.array),s=ei(s,this.array),r=ei(r,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==of&&(e.usage=this.usage),e}dispose(){this.dispatchEvent({type:"dispose"})}};var Ha=class extends ri{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Wa=class extends ri{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var It=class extends ri{constructor(e,t,i){super(new Float32Array(e),t,i)}},JM=new nr,Pa=new z,qd=new z,Br=class{constructor(e=new z,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):JM.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Pa.subVectors(e,this.center);let t=Pa.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Pa,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(qd.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Pa.copy(e.center).add(qd)),this.expandByPoint(Pa.copy(e.center).sub(qd))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},jM=0,Ni=new Vt,Yd=new Si,Io=new z,yi=new nr,Ia=new nr,Dn=new z,yn=class n extends Zi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:jM++}),this.uuid=qo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(MM(e)?Wa:Ha)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new nt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ni.makeRotationFromQuaternion(e),this.applyMatrix4(Ni),this}rotateX(e){return Ni.makeRotationX(e),this.applyMatrix4(Ni),this}rotateY(e){return Ni.makeRotationY(e),this.applyMatrix4(Ni),this}rotateZ(e){return Ni.makeRotationZ(e),this.applyMatrix4(Ni),this}translate(e,t,i){return Ni.makeTranslation(e,t,i),this.applyMatrix4(Ni),this}scale(e,t,i){return Ni.makeScale(e,t,i),this.applyMatrix4(Ni),this}lookAt(e){return Yd.lookAt(e),Yd.updateMatrix(),this.applyMatrix4(Yd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Io).negate(),this.translate(Io.x,Io.y,Io.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new It(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ye("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new nr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Je("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new z(-1/0,-1/0,-1/0),new z(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];yi.setFromBufferAttribute(r),this.morphTargetsRelative?(Dn.addVectors(this.boundingBox.min,yi.min),this.boundingBox.expandByPoint(Dn),Dn.addVectors(this.boundingBox.max,yi.max),this.boundingBox.expandByPoint(Dn)):(this.boundingBox.expandByPoint(yi.min),this.boundingBox.expandByPoint(yi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Je('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Br);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Je("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new z,1/0);return}if(e){let i=this.boundingSphere.center;if(yi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Ia.setFromBufferAttribute(a),this.morphTargetsRelative?(Dn.addVectors(yi.min,Ia.min),yi.expandByPoint(Dn),Dn.addVectors(yi.max,Ia.max),yi.expandByPoint(Dn)):(yi.expandByPoint(Ia.min),yi.expandByPoint(Ia.max))}yi.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Dn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Dn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Dn.fromBufferAttribute(a,c),l&&(Io.fromBufferAttribute(e,c),Dn.add(Io)),s=Math.max(s,i.distanceToSquared(Dn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Je('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Je("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new ri(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[];for(let y=0;y<i.count;y++)a[y]=new z,l[y]=new z;let c=new z,u=new z,d=new z,h=new je,f=new je,m=new je,v=new z,g=new z;function p(y,A,F){c.fromBufferAttribute(i,y),u.fromBufferAttribute(i,A),d.fromBufferAttribute(i,F),h.fromBufferAttribute(r,y),f.fromBufferAttribute(r,A),m.fromBufferAttribute(r,F),u.sub(c),d.sub(c),f.sub(h),m.sub(h);let L=1/(f.x*m.y-m.x*f.y);isFinite(L)&&(v.copy(u).multiplyScalar(m.y).addScaledVector(d,-f.y).multiplyScalar(L),g.copy(d).multiplyScalar(f.x).addScaledVector(u,-m.x).multiplyScalar(L),a[y].add(v),a[A].add(v),a[F].add(v),l[y].add(g),l[A].add(g),l[F].add(g))}let S=this.groups;S.length===0&&(S=[{start:0,count:e.count}]);for(let y=0,A=S.length;y<A;++y){let F=S[y],L=F.start,U=F.count;for(let G=L,q=L+U;G<q;G+=3)p(e.getX(G+0),e.getX(G+1),e.getX(G+2))}let C=new z,b=new z,E=new z,T=new z;function D(y){E.fromBufferAttribute(s,y),T.copy(E);let A=a[y];C.copy(A),C.sub(E.multiplyScalar(E.dot(A))).normalize(),b.crossVectors(T,A);let L=b.dot(l[y])<0?-1:1;o.setXYZW(y,C.x,C.y,C.z,L)}for(let y=0,A=S.length;y<A;++y){let F=S[y],L=F.start,U=F.count;for(let G=L,q=L+U;G<q;G+=3)D(e.getX(G+0)),D(e.getX(G+1)),D(e.getX(G+2))}this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new ri(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,f=i.count;h<f;h++)i.setXYZ(h,0,0,0);let s=new z,r=new z,o=new z,a=new z,l=new z,c=new z,u=new z,d=new z;if(e)for(let h=0,f=e.count;h<f;h+=3){let m=e.getX(h+0),v=e.getX(h+1),g=e.getX(h+2);s.fromBufferAttribute(t,m),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,g),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let h=0,f=t.count;h<f;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Dn.fromBufferAttribute(e,t),Dn.normalize(),e.setXYZ(t,Dn.x,Dn.y,Dn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,d=a.normalized,h=new c.constructor(l.length*u),f=0,m=0;for(let v=0,g=l.length;v<g;v++){a.isInterleavedBufferAttribute?f=l[v]*a.data.stride+a.offset:f=l[v]*u;for(let p=0;p<u;p++)h[m++]=c[f++]}return new ri(h,u,d)}if(this.index===null)return Ye("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,d=c.length;u<d;u++){let h=c[u],f=e(h,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let d=0,h=c.length;d<h;d++){let f=c[d];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],d=r[c];for(let h=0,f=d.length;h<f;h++)u.push(d[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var QM=0,ir=class extends Zi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:QM++}),this.uuid=qo(),this.name="",this.type="Material",this.blending=Ur,this.side=$i,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Bc,this.blendDst=kc,this.blendEquation=er,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new xt(0,0,0),this.blendAlpha=0,this.depthFunc=Or,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=rf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Dr,this.stencilZFail=Dr,this.stencilZPass=Dr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ye(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==Ur&&(i.blending=this.blending),this.side!==$i&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==Bc&&(i.blendSrc=this.blendSrc),this.blendDst!==kc&&(i.blendDst=this.blendDst),this.blendEquation!==er&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==Or&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==rf&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Dr&&(i.stencilFail=this.stencilFail),this.stencilZFail!==Dr&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==Dr&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.allowOverride===!1&&(i.allowOverride=!1),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new xt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessRange=e.iridescenceThicknessRange),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new je().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new je().fromArray(e.clearcoatNormalScale)),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ws=new z,$d=new z,Mc=new z,Js=new z,Zd=new z,Sc=new z,Kd=new z,kr=class{constructor(e=new z,t=new z(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ws)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ws.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ws.copy(this.origin).addScaledVector(this.direction,t),ws.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){$d.copy(e).add(t).multiplyScalar(.5),Mc.copy(t).sub(e).normalize(),Js.copy(this.origin).sub($d);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Mc),a=Js.dot(this.direction),l=-Js.dot(Mc),c=Js.lengthSq(),u=Math.abs(1-o*o),d,h,f,m;if(u>0)if(d=o*l-a,h=o*a-l,m=r*u,d>=0)if(h>=-m)if(h<=m){let v=1/u;d*=v,h*=v,f=d*(d+o*h+2*a)+h*(o*d+h+2*l)+c}else h=r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;else h=-r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;else h<=-m?(d=Math.max(0,-(-o*r+a)),h=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+h*(h+2*l)+c):h<=m?(d=0,h=Math.min(Math.max(-r,-l),r),f=h*(h+2*l)+c):(d=Math.max(0,-(o*r+a)),h=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+h*(h+2*l)+c);else h=o>0?-r:r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy($d).addScaledVector(Mc,h),f}intersectSphere(e,t){ws.subVectors(e.center,this.origin);let i=ws.dot(this.direction),s=ws.dot(ws)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,d=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(e.min.z-h.z)*d,l=(e.max.z-h.z)*d):(a=(e.max.z-h.z)*d,l=(e.min.z-h.z)*d),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,ws)!==null}intersectTriangle(e,t,i,s,r){Zd.subVectors(t,e),Sc.subVectors(i,e),Kd.crossVectors(Zd,Sc);let o=this.direction.dot(Kd),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;Js.subVectors(this.origin,e);let l=a*this.direction.dot(Sc.crossVectors(Js,Sc));if(l<0)return null;let c=a*this.direction.dot(Zd.cross(Js));if(c<0||l+c>o)return null;let u=-a*Js.dot(Kd);return u<0?null:this.at(u/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Xa=class extends ir{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new xt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new tr,this.combine=ff,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},t_=new Vt,Lr=new kr,wc=new Br,n_=new z,Tc=new z,Ec=new z,Ac=new z,Jd=new z,Cc=new z,i_=new z,Rc=new z,Ot=class extends Si{constructor(e=new yn,t=new Xa){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Cc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],d=r[l];u!==0&&(Jd.fromBufferAttribute(d,e),o?Cc.addScaledVector(Jd,u):Cc.addScaledVector(Jd.sub(t),u))}t.add(Cc)}return t}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),wc.copy(i.boundingSphere),wc.applyMatrix4(r),Lr.copy(e.ray).recast(e.near),!(wc.containsPoint(Lr.origin)===!1&&(Lr.intersectSphere(wc,n_)===null||Lr.origin.distanceToSquared(n_)>(e.far-e.near)**2))&&(t_.copy(r).invert(),Lr.copy(e.ray).applyMatrix4(t_),!(i.boundingBox!==null&&Lr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Lr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,d=r.attributes.normal,h=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,v=h.length;m<v;m++){let g=h[m],p=o[g.materialIndex],S=Math.max(g.start,f.start),C=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let b=S,E=C;b<E;b+=3){let T=a.getX(b),D=a.getX(b+1),y=a.getX(b+2);s=Pc(this,p,e,i,c,u,d,T,D,y),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let m=Math.max(0,f.start),v=Math.min(a.count,f.start+f.count);for(let g=m,p=v;g<p;g+=3){let S=a.getX(g),C=a.getX(g+1),b=a.getX(g+2);s=Pc(this,o,e,i,c,u,d,S,C,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,v=h.length;m<v;m++){let g=h[m],p=o[g.materialIndex],S=Math.max(g.start,f.start),C=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let b=S,E=C;b<E;b+=3){let T=b,D=b+1,y=b+2;s=Pc(this,p,e,i,c,u,d,T,D,y),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let m=Math.max(0,f.start),v=Math.min(l.count,f.start+f.count);for(let g=m,p=v;g<p;g+=3){let S=g,C=g+1,b=g+2;s=Pc(this,o,e,i,c,u,d,S,C,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function eS(n,e,t,i,s,r,o,a){let l;if(e.side===ti?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===$i,a),l===null)return null;Rc.copy(a),Rc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Rc);return c<t.near||c>t.far?null:{distance:c,point:Rc.clone(),object:n}}function Pc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Tc),n.getVertexPosition(l,Ec),n.getVertexPosition(c,Ac);let u=eS(n,e,t,i,Tc,Ec,Ac,i_);if(u){let d=new z;Qs.getBarycoord(i_,Tc,Ec,Ac,d),s&&(u.uv=Qs.getInterpolatedAttribute(s,a,l,c,d,new je)),r&&(u.uv1=Qs.getInterpolatedAttribute(r,a,l,c,d,new je)),o&&(u.normal=Qs.getInterpolatedAttribute(o,a,l,c,d,new z),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new z,materialIndex:0};Qs.getNormal(Tc,Ec,Ac,h.normal),u.face=h,u.barycoord=d}return u}var Vr=class extends oi{constructor(e=null,t=1,i=1,s,r,o,a,l,c=vn,u=vn,d,h){super(null,o,a,l,c,u,s,r,d,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var qa=class extends ri{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var jd=new z,tS=new z,nS=new nt,Di=class{constructor(e=new z(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=jd.subVectors(i,t).cross(tS.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(jd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||nS.getNormalMatrix(e),s=this.coplanarPoint(jd).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}},Nr=new Br,iS=new je(.5,.5),Ic=new z,Ya=class{constructor(e=new Di,t=new Di,i=new Di,s=new Di,r=new Di,o=new Di){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Yi,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],d=r[5],h=r[6],f=r[7],m=r[8],v=r[9],g=r[10],p=r[11],S=r[12],C=r[13],b=r[14],E=r[15];if(s[0].setComponents(c-o,f-u,p-m,E-S).normalize(),s[1].setComponents(c+o,f+u,p+m,E+S).normalize(),s[2].setComponents(c+a,f+d,p+v,E+C).normalize(),s[3].setComponents(c-a,f-d,p-v,E-C).normalize(),i)s[4].setComponents(l,h,g,b).normalize(),s[5].setComponents(c-l,f-h,p-g,E-b).normalize();else if(s[4].setComponents(c-l,f-h,p-g,E-b).normalize(),t===Yi)s[5].setComponents(c+l,f+h,p+g,E+b).normalize();else if(t===Ba)s[5].setComponents(l,h,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Nr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Nr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Nr)}intersectsSprite(e){Nr.center.set(0,0,0);let t=iS.distanceTo(e.center);return Nr.radius=.7071067811865476+t,Nr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Nr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Ic.x=s.normal.x>0?e.max.x:e.min.x,Ic.y=s.normal.y>0?e.max.y:e.min.y,Ic.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Ic)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var Vo=class extends ir{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new xt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Qc=new z,eu=new z,s_=new Vt,La=new kr,Lc=new Br,Qd=new z,r_=new z,zo=class extends Si{constructor(e=new yn,t=new Vo){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Qc.fromBufferAttribute(t,s-1),eu.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Qc.distanceTo(eu);e.setAttribute("lineDistance",new It(i,1))}else Ye("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Lc.copy(i.boundingSphere),Lc.applyMatrix4(s),Lc.radius+=r,e.ray.intersectsSphere(Lc)===!1)return;s_.copy(s).invert(),La.copy(e.ray).applyMatrix4(s_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let v=f,g=m-1;v<g;v+=c){let p=u.getX(v),S=u.getX(v+1),C=Nc(this,e,La,l,p,S,v);C&&t.push(C)}if(this.isLineLoop){let v=u.getX(m-1),g=u.getX(f),p=Nc(this,e,La,l,v,g,m-1);p&&t.push(p)}}else{let f=Math.max(0,o.start),m=Math.min(h.count,o.start+o.count);for(let v=f,g=m-1;v<g;v+=c){let p=Nc(this,e,La,l,v,v+1,v);p&&t.push(p)}if(this.isLineLoop){let v=Nc(this,e,La,l,m-1,f,m-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Nc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Qc.fromBufferAttribute(a,s),eu.fromBufferAttribute(a,r),t.distanceSqToSegment(Qc,eu,Qd,r_)>i)return;Qd.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Qd);if(!(c<e.near||c>e.far))return{distance:c,point:r_.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var $a=class extends oi{constructor(e=[],t=cr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var As=class extends oi{constructor(e,t,i=Ji,s,r,o,a=vn,l=vn,c,u=ls,d=1){if(u!==ls&&u!==hr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:d};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Bo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}},tu=class extends As{constructor(e,t=Ji,i=cr,s,r,o=vn,a=vn,l,c=ls){let u={width:e,height:e,depth:1},d=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Za=class extends oi{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Cs=class n extends yn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],d=[],h=0,f=0;m("z","y","x",-1,-1,i,t,e,o,r,0),m("z","y","x",1,-1,i,t,-e,o,r,1),m("x","z","y",1,1,e,i,t,s,o,2),m("x","z","y",1,-1,e,i,-t,s,o,3),m("x","y","z",1,-1,e,t,i,s,r,4),m("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new It(c,3)),this.setAttribute("normal",new It(u,3)),this.setAttribute("uv",new It(d,2));function m(v,g,p,S,C,b,E,T,D,y,A){let F=b/D,L=E/y,U=b/2,G=E/2,q=T/2,O=D+1,Y=y+1,H=0,ie=0,oe=new z;for(let le=0;le<Y;le++){let de=le*L-G;for(let ue=0;ue<O;ue++){let _e=ue*F-U;oe[v]=_e*S,oe[g]=de*C,oe[p]=q,c.push(oe.x,oe.y,oe.z),oe[v]=0,oe[g]=0,oe[p]=T>0?1:-1,u.push(oe.x,oe.y,oe.z),d.push(ue/D),d.push(1-le/y),H+=1}}for(let le=0;le<y;le++)for(let de=0;de<D;de++){let ue=h+de+O*le,_e=h+de+O*(le+1),st=h+(de+1)+O*(le+1),Qe=h+(de+1)+O*le;l.push(ue,_e,Qe),l.push(_e,st,Qe),ie+=6}a.addGroup(f,ie,A),f+=ie,h+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Rs=class n extends yn{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],d=[],h=[],f=[],m=0,v=[],g=i/2,p=0;S(),o===!1&&(e>0&&C(!0),t>0&&C(!1)),this.setIndex(u),this.setAttribute("position",new It(d,3)),this.setAttribute("normal",new It(h,3)),this.setAttribute("uv",new It(f,2));function S(){let b=new z,E=new z,T=0,D=(t-e)/i;for(let y=0;y<=r;y++){let A=[],F=y/r,L=F*(t-e)+e;for(let U=0;U<=s;U++){let G=U/s,q=G*l+a,O=Math.sin(q),Y=Math.cos(q);E.x=L*O,E.y=-F*i+g,E.z=L*Y,d.push(E.x,E.y,E.z),b.set(O,D,Y).normalize(),h.push(b.x,b.y,b.z),f.push(G,1-F),A.push(m++)}v.push(A)}for(let y=0;y<s;y++)for(let A=0;A<r;A++){let F=v[A][y],L=v[A+1][y],U=v[A+1][y+1],G=v[A][y+1];(e>0||A!==0)&&(u.push(F,L,G),T+=3),(t>0||A!==r-1)&&(u.push(L,U,G),T+=3)}c.addGroup(p,T,0),p+=T}function C(b){let E=m,T=new je,D=new z,y=0,A=b===!0?e:t,F=b===!0?1:-1;for(let U=1;U<=s;U++)d.push(0,g*F,0),h.push(0,F,0),f.push(.5,.5),m++;let L=m;for(let U=0;U<=s;U++){let q=U/s*l+a,O=Math.cos(q),Y=Math.sin(q);D.x=A*Y,D.y=g*F,D.z=A*O,d.push(D.x,D.y,D.z),h.push(0,F,0),T.x=O*.5+.5,T.y=Y*.5*F+.5,f.push(T.x,T.y),m++}for(let U=0;U<s;U++){let G=E+U,q=L+U;b===!0?u.push(q,q+1,G):u.push(q+1,q,G),y+=3}c.addGroup(p,y,b===!0?1:2),p+=y}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var zr=class n extends yn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,d=e/a,h=t/l,f=[],m=[],v=[],g=[];for(let p=0;p<u;p++){let S=p*h-o;for(let C=0;C<c;C++){let b=C*d-r;m.push(b,-S,0),v.push(0,0,1),g.push(C/a),g.push(1-p/l)}}for(let p=0;p<l;p++)for(let S=0;S<a;S++){let C=S+c*p,b=S+c*(p+1),E=S+1+c*(p+1),T=S+1+c*p;f.push(C,b,T),f.push(b,E,T)}this.setIndex(f),this.setAttribute("position",new It(m,3)),this.setAttribute("normal",new It(v,3)),this.setAttribute("uv",new It(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var Ka=class n extends yn{constructor(e=1,t=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],d=[],h=new z,f=new z,m=new z;for(let v=0;v<=i;v++){let g=o+v/i*a;for(let p=0;p<=s;p++){let S=p/s*r;f.x=(e+t*Math.cos(g))*Math.cos(S),f.y=(e+t*Math.cos(g))*Math.sin(S),f.z=t*Math.sin(g),c.push(f.x,f.y,f.z),h.x=e*Math.cos(S),h.y=e*Math.sin(S),m.subVectors(f,h).normalize(),u.push(m.x,m.y,m.z),d.push(p/s),d.push(v/i)}}for(let v=1;v<=i;v++)for(let g=1;g<=s;g++){let p=(s+1)*v+g-1,S=(s+1)*(v-1)+g-1,C=(s+1)*(v-1)+g,b=(s+1)*v+g;l.push(p,S,b),l.push(S,C,b)}this.setIndex(l),this.setAttribute("position",new It(c,3)),this.setAttribute("normal",new It(u,3)),this.setAttribute("uv",new It(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc)}};function Hr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(o_(s))s.isRenderTargetTexture?(Ye("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(o_(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Wn(n){let e={};for(let t=0;t<n.length;t++){let i=Hr(n[t]);for(let s in i)e[s]=i[s]}return e}function o_(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function sS(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Df(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:_t.workingColorSpace}var q_={clone:Hr,merge:Wn},rS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,oS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,an=class extends ir{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=rS,this.fragmentShader=oS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Hr(e.uniforms),this.uniformsGroups=sS(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new xt().setHex(s.value);break;case"v2":this.uniforms[i].value=new je().fromArray(s.value);break;case"v3":this.uniforms[i].value=new z().fromArray(s.value);break;case"v4":this.uniforms[i].value=new jt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new nt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Vt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},nu=class extends an{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var iu=class extends ir{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=N_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},su=class extends ir{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Dc(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}var sr=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},ru=class extends sr{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:tf,endingEnd:tf}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case nf:r=e,a=2*t-i;break;case sf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case nf:o=e,l=2*i-t;break;case sf:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,d=this._offsetNext,h=this._weightPrev,f=this._weightNext,m=(i-t)/(s-t),v=m*m,g=v*m,p=-h*g+2*h*v-h*m,S=(1+h)*g+(-1.5-2*h)*v+(-.5+h)*m+1,C=(-1-f)*g+(1.5+f)*v+.5*m,b=f*g-f*v;for(let E=0;E!==a;++E)r[E]=p*o[u+E]+S*o[c+E]+C*o[l+E]+b*o[d+E];return r}},ou=class extends sr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),d=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*d+o[l+h]*u;return r}},au=class extends sr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},lu=class extends sr{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,d=this.outTangents;if(!u||!d){let m=(i-t)/(s-t),v=1-m;for(let g=0;g!==a;++g)r[g]=o[c+g]*v+o[l+g]*m;return r}let h=a*2,f=e-1;for(let m=0;m!==a;++m){let v=o[c+m],g=o[l+m],p=f*h+m*2,S=d[p],C=d[p+1],b=e*h+m*2,E=u[b],T=u[b+1],D=(i-t)/(s-t),y,A,F,L,U;for(let G=0;G<8;G++){y=D*D,A=y*D,F=1-D,L=F*F,U=L*F;let O=U*t+3*L*D*S+3*F*y*E+A*s-i;if(Math.abs(O)<1e-10)break;let Y=3*L*(S-t)+6*F*D*(E-S)+3*y*(s-E);if(Math.abs(Y)<1e-10)break;D=D-O/Y,D=Math.max(0,Math.min(1,D))}r[m]=U*v+3*L*D*C+3*F*y*T+A*g}return r}},wi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Dc(t,this.TimeBufferType),this.values=Dc(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Dc(e.times,Array),values:Dc(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s)}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new au(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new ou(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new ru(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new lu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Fa:t=this.InterpolantFactoryMethodDiscrete;break;case Zc:t=this.InterpolantFactoryMethodLinear;break;case Oc:t=this.InterpolantFactoryMethodSmooth;break;case ef:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ye("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Fa;case this.InterpolantFactoryMethodLinear:return Zc;case this.InterpolantFactoryMethodSmooth:return Oc;case this.InterpolantFactoryMethodBezier:return ef}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Je("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Je("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Je("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Je("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&SM(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Je("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Oc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let d=a*i,h=d-i,f=d+i;for(let m=0;m!==i;++m){let v=t[d+m];if(v!==t[h+m]||v!==t[f+m]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let d=a*i,h=o*i;for(let f=0;f!==i;++f)t[h+f]=t[d+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,s}};wi.prototype.ValueTypeName="";wi.prototype.TimeBufferType=Float32Array;wi.prototype.ValueBufferType=Float32Array;wi.prototype.DefaultInterpolation=Zc;var rr=class extends wi{constructor(e,t,i){super(e,t,i)}};rr.prototype.ValueTypeName="bool";rr.prototype.ValueBufferType=Array;rr.prototype.DefaultInterpolation=Fa;rr.prototype.InterpolantFactoryMethodLinear=void 0;rr.prototype.InterpolantFactoryMethodSmooth=void 0;var cu=class extends wi{constructor(e,t,i,s){super(e,t,i,s)}};cu.prototype.ValueTypeName="color";var uu=class extends wi{constructor(e,t,i,s){super(e,t,i,s)}};uu.prototype.ValueTypeName="number";var hu=class extends sr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Hn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ja=class extends wi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new hu(this.times,this.values,this.getValueSize(),e)}};Ja.prototype.ValueTypeName="quaternion";Ja.prototype.InterpolantFactoryMethodSmooth=void 0;var or=class extends wi{constructor(e,t,i){super(e,t,i)}};or.prototype.ValueTypeName="string";or.prototype.ValueBufferType=Array;or.prototype.DefaultInterpolation=Fa;or.prototype.InterpolantFactoryMethodLinear=void 0;or.prototype.InterpolantFactoryMethodSmooth=void 0;var du=class extends wi{constructor(e,t,i,s){super(e,t,i,s)}};du.prototype.ValueTypeName="vector";var fu=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,d){return c.push(u,d),this},this.removeHandler=function(u){let d=c.indexOf(u);return d!==-1&&c.splice(d,2),this},this.getHandler=function(u){for(let d=0,h=c.length;d<h;d+=2){let f=c[d],m=c[d+1];if(f.global&&(f.lastIndex=0),f.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Y_=new fu,pu=class{constructor(e){this.manager=e!==void 0?e:Y_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}abort(){return this}};pu.DEFAULT_MATERIAL_NAME="__DEFAULT";var Fc=new z,Uc=new Hn,os=new z,ja=class extends Si{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Vt,this.projectionMatrix=new Vt,this.projectionMatrixInverse=new Vt,this.coordinateSystem=Yi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Fc,Uc,os),os.x===1&&os.y===1&&os.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Fc,Uc,os.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Fc,Uc,os),os.x===1&&os.y===1&&os.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Fc,Uc,os.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},js=new z,a_=new je,l_=new je,Gn=class extends ja{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Oo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Na*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Oo*2*Math.atan(Math.tan(Na*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){js.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(js.x,js.y).multiplyScalar(-e/js.z),js.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(js.x,js.y).multiplyScalar(-e/js.z)}getViewSize(e,t){return this.getViewBounds(e,a_,l_),t.subVectors(l_,a_)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Na*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Qa=class extends ja{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var el=class extends yn{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Lo=-90,No=1,mu=class extends Si{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Gn(Lo,No,e,t);s.layers=this.layers,this.add(s);let r=new Gn(Lo,No,e,t);r.layers=this.layers,this.add(r);let o=new Gn(Lo,No,e,t);o.layers=this.layers,this.add(o);let a=new Gn(Lo,No,e,t);a.layers=this.layers,this.add(a);let l=new Gn(Lo,No,e,t);l.layers=this.layers,this.add(l);let c=new Gn(Lo,No,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Yi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Ba)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,d=e.getRenderTarget(),h=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let v=i.texture.generateMipmaps;i.texture.generateMipmaps=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.generateMipmaps=v,e.setRenderTarget(i,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(d,h,f),e.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},gu=class extends Gn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}};var Ff="\\[\\]\\.:\\/",aS=new RegExp("["+Ff+"]","g"),Uf="[^"+Ff+"]",lS="[^"+Ff.replace("\\.","")+"]",cS=/((?:WC+[\/:])*)/.source.replace("WC",Uf),uS=/(WCOD+)?/.source.replace("WCOD",lS),hS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Uf),dS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Uf),fS=new RegExp("^"+cS+uS+hS+dS+"$"),pS=["material","materials","bones","map"],af=class{constructor(e,t,i){let s=i||Jt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Jt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(aS,"")}static parseTrackName(e){let t=fS.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);pS.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ye("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){Je("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Je("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Je("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Je("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Je("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){Je("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){Je("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Je("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Je("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Je("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Jt.Composite=af;Jt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Jt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Jt.prototype.GetterByBindingType=[Jt.prototype._getValue_direct,Jt.prototype._getValue_array,Jt.prototype._getValue_arrayElement,Jt.prototype._getValue_toArray];Jt.prototype.SetterByBindingTypeAndVersioning=[[Jt.prototype._setValue_direct,Jt.prototype._setValue_direct_setNeedsUpdate,Jt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_array,Jt.prototype._setValue_array_setNeedsUpdate,Jt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_arrayElement,Jt.prototype._setValue_arrayElement_setNeedsUpdate,Jt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_fromArray,Jt.prototype._setValue_fromArray_setNeedsUpdate,Jt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var q3=new Float32Array(1);var Go=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ut(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(ut(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var lf=class n{static{n.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var tl=class extends Zi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){if(e===void 0){Ye("Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Of(n,e,t,i){let s=mS(i);switch(t){case Ef:return n*e;case Cf:return n*e/s.components*s.byteLength;case Su:return n*e/s.components*s.byteLength;case dr:return n*e*2/s.components*s.byteLength;case wu:return n*e*2/s.components*s.byteLength;case Af:return n*e*3/s.components*s.byteLength;case ni:return n*e*4/s.components*s.byteLength;case Tu:return n*e*4/s.components*s.byteLength;case rl:case ol:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case al:case ll:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Au:case Ru:return Math.max(n,16)*Math.max(e,8)/4;case Eu:case Cu:return Math.max(n,8)*Math.max(e,8)/2;case Pu:case Iu:case Nu:case Du:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Lu:case cl:case Fu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Uu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ou:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Bu:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case ku:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Vu:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case zu:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Gu:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Hu:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Wu:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Xu:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case qu:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Yu:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case $u:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Zu:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Ku:case Ju:case ju:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Qu:case eh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case ul:case th:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function mS(n){switch(n){case Ti:case Mf:return{byteLength:1,components:1};case Wo:case Sf:case us:return{byteLength:2,components:1};case bu:case Mu:return{byteLength:2,components:4};case Ji:case yu:case Ei:return{byteLength:4,components:1};case wf:case Tf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"185"}}));typeof window<"u"&&(window.__THREE__?Ye("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="185");function gx(){let n=null,e=!1,t=null,i=null;function s(r,o){t(r,o),i=n.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function _S(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,d=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let u=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,u);else{d.sort((f,m)=>f.start-m.start);let h=0;for(let f=1;f<d.length;f++){let m=d[h],v=d[f];v.start<=m.start+m.count+1?m.count=Math.max(m.count,v.start+v.count-m.start):(++h,d[h]=v)}d.length=h+1;for(let f=0,m=d.length;f<m;f++){let v=d[f];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var xS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,vS=`#ifdef USE_ALPHAHASH
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
#endif`,yS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,bS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,MS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,SS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,wS=`#ifdef USE_AOMAP
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
#endif`,TS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,ES=`#ifdef USE_BATCHING
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
#endif`,AS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,CS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,RS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,PS=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,IS=`#ifdef USE_IRIDESCENCE
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
#endif`,LS=`#ifdef USE_BUMPMAP
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
#endif`,NS=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,DS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,FS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,US=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,OS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,BS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,kS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,VS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,zS=`#define PI 3.141592653589793
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
} // validated`,GS=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,HS=`vec3 transformedNormal = objectNormal;
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
#endif`,WS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,XS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,qS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,YS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,$S="gl_FragColor = linearToOutputTexel( gl_FragColor );",ZS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,KS=`#ifdef USE_ENVMAP
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
#endif`,JS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
#endif`,jS=`#ifdef USE_ENVMAP
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
#endif`,QS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,ew=`#ifdef USE_ENVMAP
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
#endif`,tw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,nw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,iw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,sw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,rw=`#ifdef USE_GRADIENTMAP
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
}`,ow=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,aw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,lw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,cw=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,uw=`#ifdef USE_ENVMAP
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
#endif`,hw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,dw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,fw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,pw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,mw=`PhysicalMaterial material;
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
#endif`,gw=`uniform sampler2D dfgLUT;
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
}`,_w=`
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
#endif`,xw=`#if defined( RE_IndirectDiffuse )
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
#endif`,vw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,yw=`#ifdef USE_LIGHT_PROBES_GRID
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
#endif`,bw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Mw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Sw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ww=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Tw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Ew=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Aw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Cw=`#if defined( USE_POINTS_UV )
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
#endif`,Rw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Pw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Iw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Lw=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Nw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Dw=`#ifdef USE_MORPHTARGETS
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
#endif`,Fw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Uw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Ow=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Bw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,kw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Vw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,zw=`#ifdef USE_NORMALMAP
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
#endif`,Gw=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Hw=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Ww=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Xw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,qw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Yw=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,$w=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Zw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Kw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Jw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,jw=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Qw=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,e1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,t1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,n1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,i1=`float getShadowMask() {
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
}`,s1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,r1=`#ifdef USE_SKINNING
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
#endif`,o1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,a1=`#ifdef USE_SKINNING
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
#endif`,l1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,c1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,u1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,h1=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,d1=`#ifdef USE_TRANSMISSION
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
#endif`,f1=`#ifdef USE_TRANSMISSION
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
#endif`,p1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,m1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,g1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,_1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,x1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,v1=`uniform sampler2D t2D;
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
}`,y1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,b1=`#ifdef ENVMAP_TYPE_CUBE
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
}`,M1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,S1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,w1=`#include <common>
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
}`,T1=`#if DEPTH_PACKING == 3200
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
}`,E1=`#define DISTANCE
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
}`,A1=`#define DISTANCE
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
}`,C1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,R1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,P1=`uniform float scale;
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
}`,I1=`uniform vec3 diffuse;
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
}`,L1=`#include <common>
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
}`,N1=`uniform vec3 diffuse;
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
}`,D1=`#define LAMBERT
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
}`,F1=`#define LAMBERT
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
}`,U1=`#define MATCAP
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
}`,O1=`#define MATCAP
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
}`,B1=`#define NORMAL
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
}`,k1=`#define NORMAL
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
}`,V1=`#define PHONG
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
}`,z1=`#define PHONG
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
}`,G1=`#define STANDARD
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
}`,H1=`#define STANDARD
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
}`,W1=`#define TOON
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
}`,X1=`#define TOON
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
}`,q1=`uniform float size;
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
}`,Y1=`uniform vec3 diffuse;
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
}`,$1=`#include <common>
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
}`,Z1=`uniform vec3 color;
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
}`,K1=`uniform float rotation;
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
}`,J1=`uniform vec3 diffuse;
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
}`,at={alphahash_fragment:xS,alphahash_pars_fragment:vS,alphamap_fragment:yS,alphamap_pars_fragment:bS,alphatest_fragment:MS,alphatest_pars_fragment:SS,aomap_fragment:wS,aomap_pars_fragment:TS,batching_pars_vertex:ES,batching_vertex:AS,begin_vertex:CS,beginnormal_vertex:RS,bsdfs:PS,iridescence_fragment:IS,bumpmap_pars_fragment:LS,clipping_planes_fragment:NS,clipping_planes_pars_fragment:DS,clipping_planes_pars_vertex:FS,clipping_planes_vertex:US,color_fragment:OS,color_pars_fragment:BS,color_pars_vertex:kS,color_vertex:VS,common:zS,cube_uv_reflection_fragment:GS,defaultnormal_vertex:HS,displacementmap_pars_vertex:WS,displacementmap_vertex:XS,emissivemap_fragment:qS,emissivemap_pars_fragment:YS,colorspace_fragment:$S,colorspace_pars_fragment:ZS,envmap_fragment:KS,envmap_common_pars_fragment:JS,envmap_pars_fragment:jS,envmap_pars_vertex:QS,envmap_physical_pars_fragment:uw,envmap_vertex:ew,fog_vertex:tw,fog_pars_vertex:nw,fog_fragment:iw,fog_pars_fragment:sw,gradientmap_pars_fragment:rw,lightmap_pars_fragment:ow,lights_lambert_fragment:aw,lights_lambert_pars_fragment:lw,lights_pars_begin:cw,lights_toon_fragment:hw,lights_toon_pars_fragment:dw,lights_phong_fragment:fw,lights_phong_pars_fragment:pw,lights_physical_fragment:mw,lights_physical_pars_fragment:gw,lights_fragment_begin:_w,lights_fragment_maps:xw,lights_fragment_end:vw,lightprobes_pars_fragment:yw,logdepthbuf_fragment:bw,logdepthbuf_pars_fragment:Mw,logdepthbuf_pars_vertex:Sw,logdepthbuf_vertex:ww,map_fragment:Tw,map_pars_fragment:Ew,map_particle_fragment:Aw,map_particle_pars_fragment:Cw,metalnessmap_fragment:Rw,metalnessmap_pars_fragment:Pw,morphinstance_vertex:Iw,morphcolor_vertex:Lw,morphnormal_vertex:Nw,morphtarget_pars_vertex:Dw,morphtarget_vertex:Fw,normal_fragment_begin:Uw,normal_fragment_maps:Ow,normal_pars_fragment:Bw,normal_pars_vertex:kw,normal_vertex:Vw,normalmap_pars_fragment:zw,clearcoat_normal_fragment_begin:Gw,clearcoat_normal_fragment_maps:Hw,clearcoat_pars_fragment:Ww,iridescence_pars_fragment:Xw,opaque_fragment:qw,packing:Yw,premultiplied_alpha_fragment:$w,project_vertex:Zw,dithering_fragment:Kw,dithering_pars_fragment:Jw,roughnessmap_fragment:jw,roughnessmap_pars_fragment:Qw,shadowmap_pars_fragment:e1,shadowmap_pars_vertex:t1,shadowmap_vertex:n1,shadowmask_pars_fragment:i1,skinbase_vertex:s1,skinning_pars_vertex:r1,skinning_vertex:o1,skinnormal_vertex:a1,specularmap_fragment:l1,specularmap_pars_fragment:c1,tonemapping_fragment:u1,tonemapping_pars_fragment:h1,transmission_fragment:d1,transmission_pars_fragment:f1,uv_pars_fragment:p1,uv_pars_vertex:m1,uv_vertex:g1,worldpos_vertex:_1,background_vert:x1,background_frag:v1,backgroundCube_vert:y1,backgroundCube_frag:b1,cube_vert:M1,cube_frag:S1,depth_vert:w1,depth_frag:T1,distance_vert:E1,distance_frag:A1,equirect_vert:C1,equirect_frag:R1,linedashed_vert:P1,linedashed_frag:I1,meshbasic_vert:L1,meshbasic_frag:N1,meshlambert_vert:D1,meshlambert_frag:F1,meshmatcap_vert:U1,meshmatcap_frag:O1,meshnormal_vert:B1,meshnormal_frag:k1,meshphong_vert:V1,meshphong_frag:z1,meshphysical_vert:G1,meshphysical_frag:H1,meshtoon_vert:W1,meshtoon_frag:X1,points_vert:q1,points_frag:Y1,shadow_vert:$1,shadow_frag:Z1,sprite_vert:K1,sprite_frag:J1},Ee={common:{diffuse:{value:new xt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new nt}},envmap:{envMap:{value:null},envMapRotation:{value:new nt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new nt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new nt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new nt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new nt},normalScale:{value:new je(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new nt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new nt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new nt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new nt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new xt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:null},probesMin:{value:new z},probesMax:{value:new z},probesResolution:{value:new z}},points:{diffuse:{value:new xt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0},uvTransform:{value:new nt}},sprite:{diffuse:{value:new xt(16777215)},opacity:{value:1},center:{value:new je(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}}},ds={basic:{uniforms:Wn([Ee.common,Ee.specularmap,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.fog]),vertexShader:at.meshbasic_vert,fragmentShader:at.meshbasic_frag},lambert:{uniforms:Wn([Ee.common,Ee.specularmap,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.fog,Ee.lights,{emissive:{value:new xt(0)},envMapIntensity:{value:1}}]),vertexShader:at.meshlambert_vert,fragmentShader:at.meshlambert_frag},phong:{uniforms:Wn([Ee.common,Ee.specularmap,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.fog,Ee.lights,{emissive:{value:new xt(0)},specular:{value:new xt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:at.meshphong_vert,fragmentShader:at.meshphong_frag},standard:{uniforms:Wn([Ee.common,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.roughnessmap,Ee.metalnessmap,Ee.fog,Ee.lights,{emissive:{value:new xt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag},toon:{uniforms:Wn([Ee.common,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.gradientmap,Ee.fog,Ee.lights,{emissive:{value:new xt(0)}}]),vertexShader:at.meshtoon_vert,fragmentShader:at.meshtoon_frag},matcap:{uniforms:Wn([Ee.common,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.fog,{matcap:{value:null}}]),vertexShader:at.meshmatcap_vert,fragmentShader:at.meshmatcap_frag},points:{uniforms:Wn([Ee.points,Ee.fog]),vertexShader:at.points_vert,fragmentShader:at.points_frag},dashed:{uniforms:Wn([Ee.common,Ee.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:at.linedashed_vert,fragmentShader:at.linedashed_frag},depth:{uniforms:Wn([Ee.common,Ee.displacementmap]),vertexShader:at.depth_vert,fragmentShader:at.depth_frag},normal:{uniforms:Wn([Ee.common,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,{opacity:{value:1}}]),vertexShader:at.meshnormal_vert,fragmentShader:at.meshnormal_frag},sprite:{uniforms:Wn([Ee.sprite,Ee.fog]),vertexShader:at.sprite_vert,fragmentShader:at.sprite_frag},background:{uniforms:{uvTransform:{value:new nt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:at.background_vert,fragmentShader:at.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new nt}},vertexShader:at.backgroundCube_vert,fragmentShader:at.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:at.cube_vert,fragmentShader:at.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:at.equirect_vert,fragmentShader:at.equirect_frag},distance:{uniforms:Wn([Ee.common,Ee.displacementmap,{referencePosition:{value:new z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:at.distance_vert,fragmentShader:at.distance_frag},shadow:{uniforms:Wn([Ee.lights,Ee.fog,{color:{value:new xt(0)},opacity:{value:1}}]),vertexShader:at.shadow_vert,fragmentShader:at.shadow_frag}};ds.physical={uniforms:Wn([ds.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new nt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new nt},clearcoatNormalScale:{value:new je(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new nt},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new nt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new nt},sheen:{value:0},sheenColor:{value:new xt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new nt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new nt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new nt},transmissionSamplerSize:{value:new je},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new nt},attenuationDistance:{value:0},attenuationColor:{value:new xt(0)},specularColor:{value:new xt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new nt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new nt},anisotropyVector:{value:new je},anisotropyMap:{value:null},anisotropyMapTransform:{value:new nt}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag};var sh={r:0,b:0,g:0},j1=new Vt,_x=new nt;_x.set(-1,0,0,0,1,0,0,0,1);function Q1(n,e,t,i,s,r){let o=new xt(0),a=s===!0?0:1,l,c,u=null,d=0,h=null;function f(S){let C=S.isScene===!0?S.background:null;if(C&&C.isTexture){let b=S.backgroundBlurriness>0;C=e.get(C,b)}return C}function m(S){let C=!1,b=f(S);b===null?g(o,a):b&&b.isColor&&(g(b,1),C=!0);let E=n.xr.getEnvironmentBlendMode();E==="additive"?t.buffers.color.setClear(0,0,0,1,r):E==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||C)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function v(S,C){let b=f(C);b&&(b.isCubeTexture||b.mapping===il)?(c===void 0&&(c=new Ot(new Cs(1,1,1),new an({name:"BackgroundCubeMaterial",uniforms:Hr(ds.backgroundCube.uniforms),vertexShader:ds.backgroundCube.vertexShader,fragmentShader:ds.backgroundCube.fragmentShader,side:ti,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,T,D){this.matrixWorld.copyPosition(D.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(j1.makeRotationFromEuler(C.backgroundRotation)).transpose(),b.isCubeTexture&&b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(_x),c.material.toneMapped=_t.getTransfer(b.colorSpace)!==Pt,(u!==b||d!==b.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,d=b.version,h=n.toneMapping),c.layers.enableAll(),S.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Ot(new zr(2,2),new an({name:"BackgroundMaterial",uniforms:Hr(ds.background.uniforms),vertexShader:ds.background.vertexShader,fragmentShader:ds.background.fragmentShader,side:$i,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=_t.getTransfer(b.colorSpace)!==Pt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||d!==b.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,d=b.version,h=n.toneMapping),l.layers.enableAll(),S.unshift(l,l.geometry,l.material,0,0,null))}function g(S,C){S.getRGB(sh,Df(n)),t.buffers.color.setClear(sh.r,sh.g,sh.b,C,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(S,C=1){o.set(S),a=C,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(S){a=S,g(o,a)},render:m,addToRenderList:v,dispose:p}}function eT(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(L,U,G,q,O){let Y=!1,H=d(L,q,G,U);r!==H&&(r=H,c(r.object)),Y=f(L,q,G,O),Y&&m(L,q,G,O),O!==null&&e.update(O,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,b(L,U,G,q),O!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(O).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function d(L,U,G,q){let O=q.wireframe===!0,Y=i[U.id];Y===void 0&&(Y={},i[U.id]=Y);let H=L.isInstancedMesh===!0?L.id:0,ie=Y[H];ie===void 0&&(ie={},Y[H]=ie);let oe=ie[G.id];oe===void 0&&(oe={},ie[G.id]=oe);let le=oe[O];return le===void 0&&(le=h(l()),oe[O]=le),le}function h(L){let U=[],G=[],q=[];for(let O=0;O<t;O++)U[O]=0,G[O]=0,q[O]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:U,enabledAttributes:G,attributeDivisors:q,object:L,attributes:{},index:null}}function f(L,U,G,q){let O=r.attributes,Y=U.attributes,H=0,ie=G.getAttributes();for(let oe in ie)if(ie[oe].location>=0){let de=O[oe],ue=Y[oe];if(ue===void 0&&(oe==="instanceMatrix"&&L.instanceMatrix&&(ue=L.instanceMatrix),oe==="instanceColor"&&L.instanceColor&&(ue=L.instanceColor)),de===void 0||de.attribute!==ue||ue&&de.data!==ue.data)return!0;H++}return r.attributesNum!==H||r.index!==q}function m(L,U,G,q){let O={},Y=U.attributes,H=0,ie=G.getAttributes();for(let oe in ie)if(ie[oe].location>=0){let de=Y[oe];de===void 0&&(oe==="instanceMatrix"&&L.instanceMatrix&&(de=L.instanceMatrix),oe==="instanceColor"&&L.instanceColor&&(de=L.instanceColor));let ue={};ue.attribute=de,de&&de.data&&(ue.data=de.data),O[oe]=ue,H++}r.attributes=O,r.attributesNum=H,r.index=q}function v(){let L=r.newAttributes;for(let U=0,G=L.length;U<G;U++)L[U]=0}function g(L){p(L,0)}function p(L,U){let G=r.newAttributes,q=r.enabledAttributes,O=r.attributeDivisors;G[L]=1,q[L]===0&&(n.enableVertexAttribArray(L),q[L]=1),O[L]!==U&&(n.vertexAttribDivisor(L,U),O[L]=U)}function S(){let L=r.newAttributes,U=r.enabledAttributes;for(let G=0,q=U.length;G<q;G++)U[G]!==L[G]&&(n.disableVertexAttribArray(G),U[G]=0)}function C(L,U,G,q,O,Y,H){H===!0?n.vertexAttribIPointer(L,U,G,O,Y):n.vertexAttribPointer(L,U,G,q,O,Y)}function b(L,U,G,q){v();let O=q.attributes,Y=G.getAttributes(),H=U.defaultAttributeValues;for(let ie in Y){let oe=Y[ie];if(oe.location>=0){let le=O[ie];if(le===void 0&&(ie==="instanceMatrix"&&L.instanceMatrix&&(le=L.instanceMatrix),ie==="instanceColor"&&L.instanceColor&&(le=L.instanceColor)),le!==void 0){let de=le.normalized,ue=le.itemSize,_e=e.get(le);if(_e===void 0)continue;let st=_e.buffer,Qe=_e.type,Q=_e.bytesPerElement,ae=Qe===n.INT||Qe===n.UNSIGNED_INT||le.gpuType===yu;if(le.isInterleavedBufferAttribute){let he=le.data,Ve=he.stride,De=le.offset;if(he.isInstancedInterleavedBuffer){for(let Be=0;Be<oe.locationSize;Be++)p(oe.location+Be,he.meshPerAttribute);L.isInstancedMesh!==!0&&q._maxInstanceCount===void 0&&(q._maxInstanceCount=he.meshPerAttribute*he.count)}else for(let Be=0;Be<oe.locationSize;Be++)g(oe.location+Be);n.bindBuffer(n.ARRAY_BUFFER,st);for(let Be=0;Be<oe.locationSize;Be++)C(oe.location+Be,ue/oe.locationSize,Qe,de,Ve*Q,(De+ue/oe.locationSize*Be)*Q,ae)}else{if(le.isInstancedBufferAttribute){for(let he=0;he<oe.locationSize;he++)p(oe.location+he,le.meshPerAttribute);L.isInstancedMesh!==!0&&q._maxInstanceCount===void 0&&(q._maxInstanceCount=le.meshPerAttribute*le.count)}else for(let he=0;he<oe.locationSize;he++)g(oe.location+he);n.bindBuffer(n.ARRAY_BUFFER,st);for(let he=0;he<oe.locationSize;he++)C(oe.location+he,ue/oe.locationSize,Qe,de,ue*Q,ue/oe.locationSize*he*Q,ae)}}else if(H!==void 0){let de=H[ie];if(de!==void 0)switch(de.length){case 2:n.vertexAttrib2fv(oe.location,de);break;case 3:n.vertexAttrib3fv(oe.location,de);break;case 4:n.vertexAttrib4fv(oe.location,de);break;default:n.vertexAttrib1fv(oe.location,de)}}}}S()}function E(){A();for(let L in i){let U=i[L];for(let G in U){let q=U[G];for(let O in q){let Y=q[O];for(let H in Y)u(Y[H].object),delete Y[H];delete q[O]}}delete i[L]}}function T(L){if(i[L.id]===void 0)return;let U=i[L.id];for(let G in U){let q=U[G];for(let O in q){let Y=q[O];for(let H in Y)u(Y[H].object),delete Y[H];delete q[O]}}delete i[L.id]}function D(L){for(let U in i){let G=i[U];for(let q in G){let O=G[q];if(O[L.id]===void 0)continue;let Y=O[L.id];for(let H in Y)u(Y[H].object),delete Y[H];delete O[L.id]}}}function y(L){for(let U in i){let G=i[U],q=L.isInstancedMesh===!0?L.id:0,O=G[q];if(O!==void 0){for(let Y in O){let H=O[Y];for(let ie in H)u(H[ie].object),delete H[ie];delete O[Y]}delete G[q],Object.keys(G).length===0&&delete i[U]}}}function A(){F(),o=!0,r!==s&&(r=s,c(r.object))}function F(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:A,resetDefaultState:F,dispose:E,releaseStatesOfGeometry:T,releaseStatesOfObject:y,releaseStatesOfProgram:D,initAttributes:v,enableAttribute:g,disableUnusedAttributes:S}}function tT(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let f=0;f<u;f++)h+=c[f];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function nT(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let D=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==ni&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){let y=D===us&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(D!==Ti&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==Ei&&!y)}function l(D){if(D==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ye("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let d=t.logarithmicDepthBuffer===!0,h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control");t.reversedDepthBuffer===!0&&h===!1&&Ye("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),S=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),C=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),E=n.getParameter(n.MAX_SAMPLES),T=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:m,maxTextureSize:v,maxCubemapSize:g,maxAttributes:p,maxVertexUniforms:S,maxVaryings:C,maxFragmentUniforms:b,maxSamples:E,samples:T}}function iT(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Di,a=new nt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,h){let f=d.length!==0||h||i!==0||s;return s=h,i=d.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,h){t=u(d,h,0)},this.setState=function(d,h,f){let m=d.clippingPlanes,v=d.clipIntersection,g=d.clipShadows,p=n.get(d);if(!s||m===null||m.length===0||r&&!g)r?u(null):c();else{let S=r?0:i,C=S*4,b=p.clippingState||null;l.value=b,b=u(m,h,C,f);for(let E=0;E!==C;++E)b[E]=t[E];p.clippingState=b,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=S}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(d,h,f,m){let v=d!==null?d.length:0,g=null;if(v!==0){if(g=l.value,m!==!0||g===null){let p=f+v*4,S=h.matrixWorldInverse;a.getNormalMatrix(S),(g===null||g.length<p)&&(g=new Float32Array(p));for(let C=0,b=f;C!==v;++C,b+=4)o.copy(d[C]).applyMatrix4(S,a),o.normal.toArray(g,b),g[b+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,g}}var fr=4,$_=[.125,.215,.35,.446,.526,.582],Wr=20,sT=256,hl=new Qa,Z_=new xt,Bf=null,kf=0,Vf=0,zf=!1,rT=new z,oh=class{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._sizeLods=[],this._sigmas=[],this._lodMeshes=[],this._backgroundBox=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=rT}=r;Bf=this._renderer.getRenderTarget(),kf=this._renderer.getActiveCubeFace(),Vf=this._renderer.getActiveMipmapLevel(),zf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(e,i,s,l,a),t>0&&this._blur(l,0,0,t),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=j_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=J_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._backgroundBox!==null&&(this._backgroundBox.geometry.dispose(),this._backgroundBox.material.dispose())}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodMeshes.length;e++)this._lodMeshes[e].geometry.dispose()}_cleanup(e){this._renderer.setRenderTarget(Bf,kf,Vf),this._renderer.xr.enabled=zf,e.scissorTest=!1,Yo(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===cr||e.mapping===Gr?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),Bf=this._renderer.getRenderTarget(),kf=this._renderer.getActiveCubeFace(),Vf=this._renderer.getActiveMipmapLevel(),zf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let i=t||this._allocateTargets();return this._textureToCubeUV(e,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){let e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,i={magFilter:En,minFilter:En,generateMipmaps:!1,type:us,format:ni,colorSpace:Ua,depthBuffer:!1},s=K_(e,t,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=K_(e,t,i);let{_lodMax:r}=this;({lodMeshes:this._lodMeshes,sizeLods:this._sizeLods,sigmas:this._sigmas}=oT(r)),this._blurMaterial=lT(r,e,t),this._ggxMaterial=aT(r,e,t)}return s}_compileMaterial(e){let t=new Ot(new yn,e);this._renderer.compile(t,hl)}_sceneToCubeUV(e,t,i,s,r){let l=new Gn(90,1,t,i),c=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],d=this._renderer,h=d.autoClear,f=d.toneMapping;d.getClearColor(Z_),d.toneMapping=Ki,d.autoClear=!1,d.state.buffers.depth.getReversed()&&(d.setRenderTarget(s),d.clearDepth(),d.setRenderTarget(null)),this._backgroundBox===null&&(this._backgroundBox=new Ot(new Cs,new Xa({name:"PMREM.Background",side:ti,depthWrite:!1,depthTest:!1})));let v=this._backgroundBox,g=v.material,p=!1,S=e.background;S?S.isColor&&(g.color.copy(S),e.background=null,p=!0):(g.color.copy(Z_),p=!0);for(let C=0;C<6;C++){let b=C%3;b===0?(l.up.set(0,c[C],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+u[C],r.y,r.z)):b===1?(l.up.set(0,0,c[C]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+u[C],r.z)):(l.up.set(0,c[C],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+u[C]));let E=this._cubeSize;Yo(s,b*E,C>2?E:0,E,E),d.setRenderTarget(s),p&&d.render(v,l),d.render(e,l)}d.toneMapping=f,d.autoClear=h,e.background=S}_textureToCubeUV(e,t){let i=this._renderer,s=e.mapping===cr||e.mapping===Gr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=j_()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=J_());let r=s?this._cubemapMaterial:this._equirectMaterial,o=this._lodMeshes[0];o.material=r;let a=r.uniforms;a.envMap.value=e;let l=this._cubeSize;Yo(t,0,0,3*l,2*l),i.setRenderTarget(t),i.render(o,hl)}_applyPMREM(e){let t=this._renderer,i=t.autoClear;t.autoClear=!1;let s=this._lodMeshes.length;for(let r=1;r<s;r++)this._applyGGXFilter(e,r-1,r);t.autoClear=i}_applyGGXFilter(e,t,i){let s=this._renderer,r=this._pingPongRenderTarget,o=this._ggxMaterial,a=this._lodMeshes[i];a.material=o;let l=o.uniforms,c=i/(this._lodMeshes.length-1),u=t/(this._lodMeshes.length-1),d=Math.sqrt(c*c-u*u),h=0+c*1.25,f=d*h,{_lodMax:m}=this,v=this._sizeLods[i],g=3*v*(i>m-fr?i-m+fr:0),p=4*(this._cubeSize-v);l.envMap.value=e.texture,l.roughness.value=f,l.mipInt.value=m-t,Yo(r,g,p,3*v,2*v),s.setRenderTarget(r),s.render(a,hl),l.envMap.value=r.texture,l.roughness.value=0,l.mipInt.value=m-i,Yo(e,g,p,3*v,2*v),s.setRenderTarget(e),s.render(a,hl)}_blur(e,t,i,s,r){let o=this._pingPongRenderTarget;this._halfBlur(e,o,t,i,s,"latitudinal",r),this._halfBlur(o,e,i,i,s,"longitudinal",r)}_halfBlur(e,t,i,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&Je("blur direction must be either latitudinal or longitudinal!");let u=3,d=this._lodMeshes[s];d.material=c;let h=c.uniforms,f=this._sizeLods[i]-1,m=isFinite(r)?Math.PI/(2*f):2*Math.PI/(2*Wr-1),v=r/m,g=isFinite(r)?1+Math.floor(u*v):Wr;g>Wr&&Ye(`sigmaRadians, ${r}, is too large and will clip, as it requested ${g} samples when the maximum is set to ${Wr}`);let p=[],S=0;for(let D=0;D<Wr;++D){let y=D/v,A=Math.exp(-y*y/2);p.push(A),D===0?S+=A:D<g&&(S+=2*A)}for(let D=0;D<p.length;D++)p[D]=p[D]/S;h.envMap.value=e.texture,h.samples.value=g,h.weights.value=p,h.latitudinal.value=o==="latitudinal",a&&(h.poleAxis.value=a);let{_lodMax:C}=this;h.dTheta.value=m,h.mipInt.value=C-i;let b=this._sizeLods[s],E=3*b*(s>C-fr?s-C+fr:0),T=4*(this._cubeSize-b);Yo(t,E,T,3*b,2*b),l.setRenderTarget(t),l.render(d,hl)}};function oT(n){let e=[],t=[],i=[],s=n,r=n-fr+1+$_.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);e.push(a);let l=1/a;o>n-fr?l=$_[o-n+fr-1]:o===0&&(l=0),t.push(l);let c=1/(a-2),u=-c,d=1+c,h=[u,u,d,u,d,d,u,u,d,d,u,d],f=6,m=6,v=3,g=2,p=1,S=new Float32Array(v*m*f),C=new Float32Array(g*m*f),b=new Float32Array(p*m*f);for(let T=0;T<f;T++){let D=T%3*2/3-1,y=T>2?0:-1,A=[D,y,0,D+2/3,y,0,D+2/3,y+1,0,D,y,0,D+2/3,y+1,0,D,y+1,0];S.set(A,v*m*T),C.set(h,g*m*T);let F=[T,T,T,T,T,T];b.set(F,p*m*T)}let E=new yn;E.setAttribute("position",new ri(S,v)),E.setAttribute("uv",new ri(C,g)),E.setAttribute("faceIndex",new ri(b,p)),i.push(new Ot(E,null)),s>fr&&s--}return{lodMeshes:i,sizeLods:e,sigmas:t}}function K_(n,e,t){let i=new Mi(n,e,t);return i.texture.mapping=il,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function Yo(n,e,t,i,s){n.viewport.set(e,t,i,s),n.scissor.set(e,t,i,s)}function aT(n,e,t){return new an({name:"PMREMGGXConvolution",defines:{GGX_SAMPLES:sT,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},roughness:{value:0},mipInt:{value:0}},vertexShader:ch(),fragmentShader:`

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
		`,blending:cs,depthTest:!1,depthWrite:!1})}function lT(n,e,t){let i=new Float32Array(Wr),s=new z(0,1,0);return new an({name:"SphericalGaussianBlur",defines:{n:Wr,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:ch(),fragmentShader:`

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
		`,blending:cs,depthTest:!1,depthWrite:!1})}function J_(){return new an({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:ch(),fragmentShader:`

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
		`,blending:cs,depthTest:!1,depthWrite:!1})}function j_(){return new an({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:ch(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:cs,depthTest:!1,depthWrite:!1})}function ch(){return`

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
	`}var ah=class extends Mi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new $a(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Cs(5,5,5),r=new an({name:"CubemapFromEquirect",uniforms:Hr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ti,blending:cs});r.uniforms.tEquirect.value=t;let o=new Ot(s,r),a=t.minFilter;return t.minFilter===ur&&(t.minFilter=En),new mu(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}};function cT(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,f=!1){return h==null?null:f?o(h):r(h)}function r(h){if(h&&h.isTexture){let f=h.mapping;if(f===_u||f===xu)if(e.has(h)){let m=e.get(h).texture;return a(m,h.mapping)}else{let m=h.image;if(m&&m.height>0){let v=new ah(m.height);return v.fromEquirectangularTexture(n,h),e.set(h,v),h.addEventListener("dispose",c),a(v.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture){let f=h.mapping,m=f===_u||f===xu,v=f===cr||f===Gr;if(m||v){let g=t.get(h),p=g!==void 0?g.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==p)return i===null&&(i=new oh(n)),g=m?i.fromEquirectangular(h,g):i.fromCubemap(h,g),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),g.texture;if(g!==void 0)return g.texture;{let S=h.image;return m&&S&&S.height>0||v&&S&&l(S)?(i===null&&(i=new oh(n)),g=m?i.fromEquirectangular(h):i.fromCubemap(h),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),h.addEventListener("dispose",u),g.texture):null}}}return h}function a(h,f){return f===_u?h.mapping=cr:f===xu&&(h.mapping=Gr),h}function l(h){let f=0,m=6;for(let v=0;v<m;v++)h[v]!==void 0&&f++;return f===m}function c(h){let f=h.target;f.removeEventListener("dispose",c);let m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function u(h){let f=h.target;f.removeEventListener("dispose",u);let m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function d(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function uT(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&Fr("WebGLRenderer: "+i+" extension not supported."),s}}}function hT(n,e,t,i){let s={},r=new WeakMap;function o(d){let h=d.target;h.index!==null&&e.remove(h.index);for(let m in h.attributes)e.remove(h.attributes[m]);h.removeEventListener("dispose",o),delete s[h.id];let f=r.get(h);f&&(e.remove(f),r.delete(h)),i.releaseStatesOfGeometry(h),h.isInstancedBufferGeometry===!0&&delete h._maxInstanceCount,t.memory.geometries--}function a(d,h){return s[h.id]===!0||(h.addEventListener("dispose",o),s[h.id]=!0,t.memory.geometries++),h}function l(d){let h=d.attributes;for(let f in h)e.update(h[f],n.ARRAY_BUFFER)}function c(d){let h=[],f=d.index,m=d.attributes.position,v=0;if(m===void 0)return;if(f!==null){let S=f.array;v=f.version;for(let C=0,b=S.length;C<b;C+=3){let E=S[C+0],T=S[C+1],D=S[C+2];h.push(E,T,T,D,D,E)}}else{let S=m.array;v=m.version;for(let C=0,b=S.length/3-1;C<b;C+=3){let E=C+0,T=C+1,D=C+2;h.push(E,T,T,D,D,E)}}let g=new(m.count>=65535?Wa:Ha)(h,1);g.version=v;let p=r.get(d);p&&e.remove(p),r.set(d,g)}function u(d){let h=r.get(d);if(h){let f=d.index;f!==null&&h.version<f.version&&c(d)}else c(d);return r.get(d)}return{get:a,update:l,getWireframeAttribute:u}}function dT(n,e,t){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,h){n.drawElements(i,h,r,d*o),t.update(h,i,1)}function c(d,h,f){f!==0&&(n.drawElementsInstanced(i,h,r,d*o,f),t.update(h,i,f))}function u(d,h,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,d,0,f);let v=0;for(let g=0;g<f;g++)v+=h[g];t.update(v,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function fT(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:Je("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function pT(n,e,t){let i=new WeakMap,s=new jt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==d){let A=function(){D.dispose(),i.delete(a),a.removeEventListener("dispose",A)};h!==void 0&&h.texture.dispose();let f=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],S=a.morphAttributes.color||[],C=0;f===!0&&(C=1),m===!0&&(C=2),v===!0&&(C=3);let b=a.attributes.position.count*C,E=1;b>e.maxTextureSize&&(E=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let T=new Float32Array(b*E*4*d),D=new Va(T,b,E,d);D.type=Ei,D.needsUpdate=!0;let y=C*4;for(let F=0;F<d;F++){let L=g[F],U=p[F],G=S[F],q=b*E*4*F;for(let O=0;O<L.count;O++){let Y=O*y;f===!0&&(s.fromBufferAttribute(L,O),T[q+Y+0]=s.x,T[q+Y+1]=s.y,T[q+Y+2]=s.z,T[q+Y+3]=0),m===!0&&(s.fromBufferAttribute(U,O),T[q+Y+4]=s.x,T[q+Y+5]=s.y,T[q+Y+6]=s.z,T[q+Y+7]=0),v===!0&&(s.fromBufferAttribute(G,O),T[q+Y+8]=s.x,T[q+Y+9]=s.y,T[q+Y+10]=s.z,T[q+Y+11]=G.itemSize===4?s.w:1)}}h={count:d,texture:D,size:new je(b,E)},i.set(a,h),a.addEventListener("dispose",A)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let v=0;v<c.length;v++)f+=c[v];let m=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function mT(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,d=c.geometry,h=e.get(c,d);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var gT={[pf]:"LINEAR_TONE_MAPPING",[mf]:"REINHARD_TONE_MAPPING",[gf]:"CINEON_TONE_MAPPING",[_f]:"ACES_FILMIC_TONE_MAPPING",[vf]:"AGX_TONE_MAPPING",[yf]:"NEUTRAL_TONE_MAPPING",[xf]:"CUSTOM_TONE_MAPPING"};function _T(n,e,t,i,s,r){let o=new Mi(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,depthTexture:s?new As(e,t):void 0}),a=new Mi(e,t,{type:us,depthBuffer:!1,stencilBuffer:!1}),l=new yn;l.setAttribute("position",new It([-1,3,0,-1,-1,0,3,-1,0],3)),l.setAttribute("uv",new It([0,2,0,0,2,0],2));let c=new nu({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new Ot(l,c),d=new Qa(-1,1,1,-1,0,1),h=null,f=null,m=!1,v,g=null,p=[],S=!1;this.setSize=function(C,b){o.setSize(C,b),a.setSize(C,b);for(let E=0;E<p.length;E++){let T=p[E];T.setSize&&T.setSize(C,b)}},this.setEffects=function(C){p=C,S=p.length>0&&p[0].isRenderPass===!0;let b=o.width,E=o.height;for(let T=0;T<p.length;T++){let D=p[T];D.setSize&&D.setSize(b,E)}},this.begin=function(C,b){if(m||C.toneMapping===Ki&&p.length===0)return!1;if(g=b,b!==null){let E=b.width,T=b.height;(o.width!==E||o.height!==T)&&this.setSize(E,T)}return S===!1&&C.setRenderTarget(o),v=C.toneMapping,C.toneMapping=Ki,!0},this.hasRenderPass=function(){return S},this.end=function(C,b){C.toneMapping=v,m=!0;let E=o,T=a;for(let D=0;D<p.length;D++){let y=p[D];if(y.enabled!==!1&&(y.render(C,T,E,b),y.needsSwap!==!1)){let A=E;E=T,T=A}}if(h!==C.outputColorSpace||f!==C.toneMapping){h=C.outputColorSpace,f=C.toneMapping,c.defines={},_t.getTransfer(h)===Pt&&(c.defines.SRGB_TRANSFER="");let D=gT[f];D&&(c.defines[D]=""),c.needsUpdate=!0}c.uniforms.tDiffuse.value=E.texture,C.setRenderTarget(g),C.render(u,d),g=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.depthTexture&&o.depthTexture.dispose(),o.dispose(),a.dispose(),l.dispose(),c.dispose()}}var xx=new oi,Wf=new As(1,1),vx=new Va,yx=new jc,bx=new $a,Q_=[],ex=[],tx=new Float32Array(16),nx=new Float32Array(9),ix=new Float32Array(4);function Zo(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=Q_[s];if(r===void 0&&(r=new Float32Array(s),Q_[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function An(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Cn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function uh(n,e){let t=ex[e];t===void 0&&(t=new Int32Array(e),ex[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function xT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function vT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(An(t,e))return;n.uniform2fv(this.addr,e),Cn(t,e)}}function yT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(An(t,e))return;n.uniform3fv(this.addr,e),Cn(t,e)}}function bT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(An(t,e))return;n.uniform4fv(this.addr,e),Cn(t,e)}}function MT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(An(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Cn(t,e)}else{if(An(t,i))return;ix.set(i),n.uniformMatrix2fv(this.addr,!1,ix),Cn(t,i)}}function ST(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(An(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Cn(t,e)}else{if(An(t,i))return;nx.set(i),n.uniformMatrix3fv(this.addr,!1,nx),Cn(t,i)}}function wT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(An(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Cn(t,e)}else{if(An(t,i))return;tx.set(i),n.uniformMatrix4fv(this.addr,!1,tx),Cn(t,i)}}function TT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function ET(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(An(t,e))return;n.uniform2iv(this.addr,e),Cn(t,e)}}function AT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(An(t,e))return;n.uniform3iv(this.addr,e),Cn(t,e)}}function CT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(An(t,e))return;n.uniform4iv(this.addr,e),Cn(t,e)}}function RT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function PT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(An(t,e))return;n.uniform2uiv(this.addr,e),Cn(t,e)}}function IT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(An(t,e))return;n.uniform3uiv(this.addr,e),Cn(t,e)}}function LT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(An(t,e))return;n.uniform4uiv(this.addr,e),Cn(t,e)}}function NT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?(Wf.compareFunction=t.isReversedDepthBuffer()?ih:nh,r=Wf):r=xx,t.setTexture2D(e||r,s)}function DT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||yx,s)}function FT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTextureCube(e||bx,s)}function UT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||vx,s)}function OT(n){switch(n){case 5126:return xT;case 35664:return vT;case 35665:return yT;case 35666:return bT;case 35674:return MT;case 35675:return ST;case 35676:return wT;case 5124:case 35670:return TT;case 35667:case 35671:return ET;case 35668:case 35672:return AT;case 35669:case 35673:return CT;case 5125:return RT;case 36294:return PT;case 36295:return IT;case 36296:return LT;case 35678:case 36198:case 36298:case 36306:case 35682:return NT;case 35679:case 36299:case 36307:return DT;case 35680:case 36300:case 36308:case 36293:return FT;case 36289:case 36303:case 36311:case 36292:return UT}}function BT(n,e){n.uniform1fv(this.addr,e)}function kT(n,e){let t=Zo(e,this.size,2);n.uniform2fv(this.addr,t)}function VT(n,e){let t=Zo(e,this.size,3);n.uniform3fv(this.addr,t)}function zT(n,e){let t=Zo(e,this.size,4);n.uniform4fv(this.addr,t)}function GT(n,e){let t=Zo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function HT(n,e){let t=Zo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function WT(n,e){let t=Zo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function XT(n,e){n.uniform1iv(this.addr,e)}function qT(n,e){n.uniform2iv(this.addr,e)}function YT(n,e){n.uniform3iv(this.addr,e)}function $T(n,e){n.uniform4iv(this.addr,e)}function ZT(n,e){n.uniform1uiv(this.addr,e)}function KT(n,e){n.uniform2uiv(this.addr,e)}function JT(n,e){n.uniform3uiv(this.addr,e)}function jT(n,e){n.uniform4uiv(this.addr,e)}function QT(n,e,t){let i=this.cache,s=e.length,r=uh(t,s);An(i,r)||(n.uniform1iv(this.addr,r),Cn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Wf:o=xx;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function eE(n,e,t){let i=this.cache,s=e.length,r=uh(t,s);An(i,r)||(n.uniform1iv(this.addr,r),Cn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||yx,r[o])}function tE(n,e,t){let i=this.cache,s=e.length,r=uh(t,s);An(i,r)||(n.uniform1iv(this.addr,r),Cn(i,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||bx,r[o])}function nE(n,e,t){let i=this.cache,s=e.length,r=uh(t,s);An(i,r)||(n.uniform1iv(this.addr,r),Cn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||vx,r[o])}function iE(n){switch(n){case 5126:return BT;case 35664:return kT;case 35665:return VT;case 35666:return zT;case 35674:return GT;case 35675:return HT;case 35676:return WT;case 5124:case 35670:return XT;case 35667:case 35671:return qT;case 35668:case 35672:return YT;case 35669:case 35673:return $T;case 5125:return ZT;case 36294:return KT;case 36295:return JT;case 36296:return jT;case 35678:case 36198:case 36298:case 36306:case 35682:return QT;case 35679:case 36299:case 36307:return eE;case 35680:case 36300:case 36308:case 36293:return tE;case 36289:case 36303:case 36311:case 36292:return nE}}var Xf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=OT(t.type)}},qf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=iE(t.type)}},Yf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},Gf=/(\w+)(\])?(\[|\.)?/g;function sx(n,e){n.seq.push(e),n.map[e.id]=e}function sE(n,e,t){let i=n.name,s=i.length;for(Gf.lastIndex=0;;){let r=Gf.exec(i),o=Gf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){sx(t,c===void 0?new Xf(a,n,e):new qf(a,n,e));break}else{let d=t.map[a];d===void 0&&(d=new Yf(a),sx(t,d)),t=d}}}var $o=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);sE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function rx(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var rE=37297,oE=0;function aE(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var ox=new nt;function lE(n){_t._getMatrix(ox,_t.workingColorSpace,n);let e=`mat3( ${ox.elements.map(t=>t.toFixed(4))} )`;switch(_t.getTransfer(n)){case Oa:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return Ye("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function ax(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+aE(n.getShaderSource(e),a)}else return r}function cE(n,e){let t=lE(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}var uE={[pf]:"Linear",[mf]:"Reinhard",[gf]:"Cineon",[_f]:"ACESFilmic",[vf]:"AgX",[yf]:"Neutral",[xf]:"Custom"};function hE(n,e){let t=uE[e];return t===void 0?(Ye("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var rh=new z;function dE(){_t.getLuminanceCoefficients(rh);let n=rh.x.toFixed(4),e=rh.y.toFixed(4),t=rh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function fE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(fl).join(`
`)}function pE(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function mE(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function fl(n){return n!==""}function lx(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function cx(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var gE=/^[ \t]*#include +<([\w\d./]+)>/gm;function $f(n){return n.replace(gE,xE)}var _E=new Map;function xE(n,e){let t=at[e];if(t===void 0){let i=_E.get(e);if(i!==void 0)t=at[i],Ye('WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,i);else throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">")}return $f(t)}var vE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function ux(n){return n.replace(vE,yE)}function yE(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function hx(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var bE={[nl]:"SHADOWMAP_TYPE_PCF",[Ho]:"SHADOWMAP_TYPE_VSM"};function ME(n){return bE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var SE={[cr]:"ENVMAP_TYPE_CUBE",[Gr]:"ENVMAP_TYPE_CUBE",[il]:"ENVMAP_TYPE_CUBE_UV"};function wE(n){return n.envMap===!1?"ENVMAP_TYPE_CUBE":SE[n.envMapMode]||"ENVMAP_TYPE_CUBE"}var TE={[Gr]:"ENVMAP_MODE_REFRACTION"};function EE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":TE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var AE={[ff]:"ENVMAP_BLENDING_MULTIPLY",[P_]:"ENVMAP_BLENDING_MIX",[I_]:"ENVMAP_BLENDING_ADD"};function CE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":AE[n.combine]||"ENVMAP_BLENDING_NONE"}function RE(n){let e=n.envMapCubeUVHeight;if(e===null)return null;let t=Math.log2(e)-2,i=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:i,maxMip:t}}function PE(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=ME(t),c=wE(t),u=EE(t),d=CE(t),h=RE(t),f=fE(t),m=pE(r),v=s.createProgram(),g,p,S=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter(fl).join(`
`),g.length>0&&(g+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter(fl).join(`
`),p.length>0&&(p+=`
`)):(g=[hx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(fl).join(`
`),p=[hx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+d:"",h?"#define CUBEUV_TEXEL_WIDTH "+h.texelWidth:"",h?"#define CUBEUV_TEXEL_HEIGHT "+h.texelHeight:"",h?"#define CUBEUV_MAX_MIP "+h.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.numLightProbeGrids>0?"#define USE_LIGHT_PROBES_GRID":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Ki?"#define TONE_MAPPING":"",t.toneMapping!==Ki?at.tonemapping_pars_fragment:"",t.toneMapping!==Ki?hE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",at.colorspace_pars_fragment,cE("linearToOutputTexel",t.outputColorSpace),dE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(fl).join(`
`)),o=$f(o),o=lx(o,t),o=cx(o,t),a=$f(a),a=lx(a,t),a=cx(a,t),o=ux(o),a=ux(a),t.isRawShaderMaterial!==!0&&(S=`#version 300 es
`,g=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+g,p=["#define varying in",t.glslVersion===Pf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Pf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let C=S+g+o,b=S+p+a,E=rx(s,s.VERTEX_SHADER,C),T=rx(s,s.FRAGMENT_SHADER,b);s.attachShader(v,E),s.attachShader(v,T),t.index0AttributeName!==void 0?s.bindAttribLocation(v,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function D(L){if(n.debug.checkShaderErrors){let U=s.getProgramInfoLog(v)||"",G=s.getShaderInfoLog(E)||"",q=s.getShaderInfoLog(T)||"",O=U.trim(),Y=G.trim(),H=q.trim(),ie=!0,oe=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(ie=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,v,E,T);else{let le=ax(s,E,"vertex"),de=ax(s,T,"fragment");Je("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+O+`
`+le+`
`+de)}else O!==""?Ye("WebGLProgram: Program Info Log:",O):(Y===""||H==="")&&(oe=!1);oe&&(L.diagnostics={runnable:ie,programLog:O,vertexShader:{log:Y,prefix:g},fragmentShader:{log:H,prefix:p}})}s.deleteShader(E),s.deleteShader(T),y=new $o(s,v),A=mE(s,v)}let y;this.getUniforms=function(){return y===void 0&&D(this),y};let A;this.getAttributes=function(){return A===void 0&&D(this),A};let F=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return F===!1&&(F=s.getProgramParameter(v,rE)),F},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=oE++,this.cacheKey=e,this.usedTimes=1,this.program=v,this.vertexShader=E,this.fragmentShader=T,this}var IE=0,Zf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Kf(e),t.set(e,i)),i}},Kf=class{constructor(e){this.id=IE++,this.code=e,this.usedTimes=0}};function LE(n){return n===dr||n===cl||n===ul}function NE(n,e,t,i,s,r){let o=new za,a=new Zf,l=new Set,c=[],u=new Map,d=i.logarithmicDepthBuffer,h=i.precision,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function m(y){return l.add(y),y===0?"uv":`uv${y}`}function v(y,A,F,L,U,G){let q=L.fog,O=U.geometry,Y=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?L.environment:null,H=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,ie=e.get(y.envMap||Y,H),oe=ie&&ie.mapping===il?ie.image.height:null,le=f[y.type];y.precision!==null&&(h=i.getMaxPrecision(y.precision),h!==y.precision&&Ye("WebGLProgram.getParameters:",y.precision,"not supported, using",h,"instead."));let de=O.morphAttributes.position||O.morphAttributes.normal||O.morphAttributes.color,ue=de!==void 0?de.length:0,_e=0;O.morphAttributes.position!==void 0&&(_e=1),O.morphAttributes.normal!==void 0&&(_e=2),O.morphAttributes.color!==void 0&&(_e=3);let st,Qe,Q,ae;if(le){let Ne=ds[le];st=Ne.vertexShader,Qe=Ne.fragmentShader}else{st=y.vertexShader,Qe=y.fragmentShader;let Ne=a.getVertexShaderStage(y),lt=a.getFragmentShaderStage(y);a.update(y,Ne,lt),Q=Ne.id,ae=lt.id}let he=n.getRenderTarget(),Ve=n.state.buffers.depth.getReversed(),De=U.isInstancedMesh===!0,Be=U.isBatchedMesh===!0,St=!!y.map,$e=!!y.matcap,ft=!!ie,ct=!!y.aoMap,ot=!!y.lightMap,Xt=!!y.bumpMap&&y.wireframe===!1,Qt=!!y.normalMap,qt=!!y.displacementMap,vt=!!y.emissiveMap,Lt=!!y.metalnessMap,Ct=!!y.roughnessMap,V=y.anisotropy>0,We=y.clearcoat>0,fe=y.dispersion>0,R=y.iridescence>0,x=y.sheen>0,X=y.transmission>0,K=V&&!!y.anisotropyMap,ee=We&&!!y.clearcoatMap,me=We&&!!y.clearcoatNormalMap,ge=We&&!!y.clearcoatRoughnessMap,te=R&&!!y.iridescenceMap,ne=R&&!!y.iridescenceThicknessMap,xe=x&&!!y.sheenColorMap,ke=x&&!!y.sheenRoughnessMap,Me=!!y.specularMap,ye=!!y.specularColorMap,Oe=!!y.specularIntensityMap,Xe=X&&!!y.transmissionMap,qe=X&&!!y.thicknessMap,k=!!y.gradientMap,be=!!y.alphaMap,se=y.alphaTest>0,Se=!!y.alphaHash,Ae=!!y.extensions,ce=Ki;y.toneMapped&&(he===null||he.isXRRenderTarget===!0)&&(ce=n.toneMapping);let ze={shaderID:le,shaderType:y.type,shaderName:y.name,vertexShader:st,fragmentShader:Qe,defines:y.defines,customVertexShaderID:Q,customFragmentShaderID:ae,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:h,batching:Be,batchingColor:Be&&U._colorsTexture!==null,instancing:De,instancingColor:De&&U.instanceColor!==null,instancingMorph:De&&U.morphTexture!==null,outputColorSpace:he===null?n.outputColorSpace:he.isXRRenderTarget===!0?he.texture.colorSpace:_t.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:St,matcap:$e,envMap:ft,envMapMode:ft&&ie.mapping,envMapCubeUVHeight:oe,aoMap:ct,lightMap:ot,bumpMap:Xt,normalMap:Qt,displacementMap:qt,emissiveMap:vt,normalMapObjectSpace:Qt&&y.normalMapType===D_,normalMapTangentSpace:Qt&&y.normalMapType===Rf,packedNormalMap:Qt&&y.normalMapType===Rf&&LE(y.normalMap.format),metalnessMap:Lt,roughnessMap:Ct,anisotropy:V,anisotropyMap:K,clearcoat:We,clearcoatMap:ee,clearcoatNormalMap:me,clearcoatRoughnessMap:ge,dispersion:fe,iridescence:R,iridescenceMap:te,iridescenceThicknessMap:ne,sheen:x,sheenColorMap:xe,sheenRoughnessMap:ke,specularMap:Me,specularColorMap:ye,specularIntensityMap:Oe,transmission:X,transmissionMap:Xe,thicknessMap:qe,gradientMap:k,opaque:y.transparent===!1&&y.blending===Ur&&y.alphaToCoverage===!1,alphaMap:be,alphaTest:se,alphaHash:Se,combine:y.combine,mapUv:St&&m(y.map.channel),aoMapUv:ct&&m(y.aoMap.channel),lightMapUv:ot&&m(y.lightMap.channel),bumpMapUv:Xt&&m(y.bumpMap.channel),normalMapUv:Qt&&m(y.normalMap.channel),displacementMapUv:qt&&m(y.displacementMap.channel),emissiveMapUv:vt&&m(y.emissiveMap.channel),metalnessMapUv:Lt&&m(y.metalnessMap.channel),roughnessMapUv:Ct&&m(y.roughnessMap.channel),anisotropyMapUv:K&&m(y.anisotropyMap.channel),clearcoatMapUv:ee&&m(y.clearcoatMap.channel),clearcoatNormalMapUv:me&&m(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:ge&&m(y.clearcoatRoughnessMap.channel),iridescenceMapUv:te&&m(y.iridescenceMap.channel),iridescenceThicknessMapUv:ne&&m(y.iridescenceThicknessMap.channel),sheenColorMapUv:xe&&m(y.sheenColorMap.channel),sheenRoughnessMapUv:ke&&m(y.sheenRoughnessMap.channel),specularMapUv:Me&&m(y.specularMap.channel),specularColorMapUv:ye&&m(y.specularColorMap.channel),specularIntensityMapUv:Oe&&m(y.specularIntensityMap.channel),transmissionMapUv:Xe&&m(y.transmissionMap.channel),thicknessMapUv:qe&&m(y.thicknessMap.channel),alphaMapUv:be&&m(y.alphaMap.channel),vertexTangents:!!O.attributes.tangent&&(Qt||V),vertexNormals:!!O.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!O.attributes.color&&O.attributes.color.itemSize===4,pointsUvs:U.isPoints===!0&&!!O.attributes.uv&&(St||be),fog:!!q,useFog:y.fog===!0,fogExp2:!!q&&q.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||O.attributes.normal===void 0&&Qt===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:Ve,skinning:U.isSkinnedMesh===!0,hasPositionAttribute:O.attributes.position!==void 0,morphTargets:O.morphAttributes.position!==void 0,morphNormals:O.morphAttributes.normal!==void 0,morphColors:O.morphAttributes.color!==void 0,morphTargetsCount:ue,morphTextureStride:_e,numDirLights:A.directional.length,numPointLights:A.point.length,numSpotLights:A.spot.length,numSpotLightMaps:A.spotLightMap.length,numRectAreaLights:A.rectArea.length,numHemiLights:A.hemi.length,numDirLightShadows:A.directionalShadowMap.length,numPointLightShadows:A.pointShadowMap.length,numSpotLightShadows:A.spotShadowMap.length,numSpotLightShadowsWithMaps:A.numSpotLightShadowsWithMaps,numLightProbes:A.numLightProbes,numLightProbeGrids:G.length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&F.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:St&&y.map.isVideoTexture===!0&&_t.getTransfer(y.map.colorSpace)===Pt,decodeVideoTextureEmissive:vt&&y.emissiveMap.isVideoTexture===!0&&_t.getTransfer(y.emissiveMap.colorSpace)===Pt,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===ai,flipSided:y.side===ti,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Ae&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ae&&y.extensions.multiDraw===!0||Be)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return ze.vertexUv1s=l.has(1),ze.vertexUv2s=l.has(2),ze.vertexUv3s=l.has(3),l.clear(),ze}function g(y){let A=[];if(y.shaderID?A.push(y.shaderID):(A.push(y.customVertexShaderID),A.push(y.customFragmentShaderID)),y.defines!==void 0)for(let F in y.defines)A.push(F),A.push(y.defines[F]);return y.isRawShaderMaterial===!1&&(p(A,y),S(A,y),A.push(n.outputColorSpace)),A.push(y.customProgramCacheKey),A.join()}function p(y,A){y.push(A.precision),y.push(A.outputColorSpace),y.push(A.envMapMode),y.push(A.envMapCubeUVHeight),y.push(A.mapUv),y.push(A.alphaMapUv),y.push(A.lightMapUv),y.push(A.aoMapUv),y.push(A.bumpMapUv),y.push(A.normalMapUv),y.push(A.displacementMapUv),y.push(A.emissiveMapUv),y.push(A.metalnessMapUv),y.push(A.roughnessMapUv),y.push(A.anisotropyMapUv),y.push(A.clearcoatMapUv),y.push(A.clearcoatNormalMapUv),y.push(A.clearcoatRoughnessMapUv),y.push(A.iridescenceMapUv),y.push(A.iridescenceThicknessMapUv),y.push(A.sheenColorMapUv),y.push(A.sheenRoughnessMapUv),y.push(A.specularMapUv),y.push(A.specularColorMapUv),y.push(A.specularIntensityMapUv),y.push(A.transmissionMapUv),y.push(A.thicknessMapUv),y.push(A.combine),y.push(A.fogExp2),y.push(A.sizeAttenuation),y.push(A.morphTargetsCount),y.push(A.morphAttributeCount),y.push(A.numDirLights),y.push(A.numPointLights),y.push(A.numSpotLights),y.push(A.numSpotLightMaps),y.push(A.numHemiLights),y.push(A.numRectAreaLights),y.push(A.numDirLightShadows),y.push(A.numPointLightShadows),y.push(A.numSpotLightShadows),y.push(A.numSpotLightShadowsWithMaps),y.push(A.numLightProbes),y.push(A.shadowMapType),y.push(A.toneMapping),y.push(A.numClippingPlanes),y.push(A.numClipIntersection),y.push(A.depthPacking)}function S(y,A){o.disableAll(),A.instancing&&o.enable(0),A.instancingColor&&o.enable(1),A.instancingMorph&&o.enable(2),A.matcap&&o.enable(3),A.envMap&&o.enable(4),A.normalMapObjectSpace&&o.enable(5),A.normalMapTangentSpace&&o.enable(6),A.clearcoat&&o.enable(7),A.iridescence&&o.enable(8),A.alphaTest&&o.enable(9),A.vertexColors&&o.enable(10),A.vertexAlphas&&o.enable(11),A.vertexUv1s&&o.enable(12),A.vertexUv2s&&o.enable(13),A.vertexUv3s&&o.enable(14),A.vertexTangents&&o.enable(15),A.anisotropy&&o.enable(16),A.alphaHash&&o.enable(17),A.batching&&o.enable(18),A.dispersion&&o.enable(19),A.batchingColor&&o.enable(20),A.gradientMap&&o.enable(21),A.packedNormalMap&&o.enable(22),A.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),A.fog&&o.enable(0),A.useFog&&o.enable(1),A.flatShading&&o.enable(2),A.logarithmicDepthBuffer&&o.enable(3),A.reversedDepthBuffer&&o.enable(4),A.skinning&&o.enable(5),A.morphTargets&&o.enable(6),A.morphNormals&&o.enable(7),A.morphColors&&o.enable(8),A.premultipliedAlpha&&o.enable(9),A.shadowMapEnabled&&o.enable(10),A.doubleSided&&o.enable(11),A.flipSided&&o.enable(12),A.useDepthPacking&&o.enable(13),A.dithering&&o.enable(14),A.transmission&&o.enable(15),A.sheen&&o.enable(16),A.opaque&&o.enable(17),A.pointsUvs&&o.enable(18),A.decodeVideoTexture&&o.enable(19),A.decodeVideoTextureEmissive&&o.enable(20),A.alphaToCoverage&&o.enable(21),A.numLightProbeGrids>0&&o.enable(22),A.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function C(y){let A=f[y.type],F;if(A){let L=ds[A];F=q_.clone(L.uniforms)}else F=y.uniforms;return F}function b(y,A){let F=u.get(A);return F!==void 0?++F.usedTimes:(F=new PE(n,A,y,s),c.push(F),u.set(A,F)),F}function E(y){if(--y.usedTimes===0){let A=c.indexOf(y);c[A]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function T(y){a.remove(y)}function D(){a.dispose()}return{getParameters:v,getProgramCacheKey:g,getUniforms:C,acquireProgram:b,releaseProgram:E,releaseShaderCache:T,programs:c,dispose:D}}function DE(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function FE(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function dx(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function fx(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let f=0;return h.isInstancedMesh&&(f+=2),h.isSkinnedMesh&&(f+=1),f}function a(h,f,m,v,g,p){let S=n[e];return S===void 0?(S={id:h.id,object:h,geometry:f,material:m,materialVariant:o(h),groupOrder:v,renderOrder:h.renderOrder,z:g,group:p},n[e]=S):(S.id=h.id,S.object=h,S.geometry=f,S.material=m,S.materialVariant=o(h),S.groupOrder=v,S.renderOrder=h.renderOrder,S.z=g,S.group=p),e++,S}function l(h,f,m,v,g,p){let S=a(h,f,m,v,g,p);m.transmission>0?i.push(S):m.transparent===!0?s.push(S):t.push(S)}function c(h,f,m,v,g,p){let S=a(h,f,m,v,g,p);m.transmission>0?i.unshift(S):m.transparent===!0?s.unshift(S):t.unshift(S)}function u(h,f,m){t.length>1&&t.sort(h||FE),i.length>1&&i.sort(f||dx),s.length>1&&s.sort(f||dx),m&&(t.reverse(),i.reverse(),s.reverse())}function d(){for(let h=e,f=n.length;h<f;h++){let m=n[h];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:d,sort:u}}function UE(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new fx,n.set(i,[o])):s>=r.length?(o=new fx,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function OE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new z,color:new xt};break;case"SpotLight":t={position:new z,direction:new z,color:new xt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new z,color:new xt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new z,skyColor:new xt,groundColor:new xt};break;case"RectAreaLight":t={color:new xt,position:new z,halfWidth:new z,halfHeight:new z};break}return n[e.id]=t,t}}}function BE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new je};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new je};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new je,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var kE=0;function VE(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function zE(n){let e=new OE,t=BE(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new z);let s=new z,r=new Vt,o=new Vt;function a(c){let u=0,d=0,h=0;for(let A=0;A<9;A++)i.probe[A].set(0,0,0);let f=0,m=0,v=0,g=0,p=0,S=0,C=0,b=0,E=0,T=0,D=0;c.sort(VE);for(let A=0,F=c.length;A<F;A++){let L=c[A],U=L.color,G=L.intensity,q=L.distance,O=null;if(L.shadow&&L.shadow.map&&(L.shadow.map.texture.format===dr?O=L.shadow.map.texture:O=L.shadow.map.depthTexture||L.shadow.map.texture),L.isAmbientLight)u+=U.r*G,d+=U.g*G,h+=U.b*G;else if(L.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(L.sh.coefficients[Y],G);D++}else if(L.isDirectionalLight){let Y=e.get(L);if(Y.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let H=L.shadow,ie=t.get(L);ie.shadowIntensity=H.intensity,ie.shadowBias=H.bias,ie.shadowNormalBias=H.normalBias,ie.shadowRadius=H.radius,ie.shadowMapSize=H.mapSize,i.directionalShadow[f]=ie,i.directionalShadowMap[f]=O,i.directionalShadowMatrix[f]=L.shadow.matrix,S++}i.directional[f]=Y,f++}else if(L.isSpotLight){let Y=e.get(L);Y.position.setFromMatrixPosition(L.matrixWorld),Y.color.copy(U).multiplyScalar(G),Y.distance=q,Y.coneCos=Math.cos(L.angle),Y.penumbraCos=Math.cos(L.angle*(1-L.penumbra)),Y.decay=L.decay,i.spot[v]=Y;let H=L.shadow;if(L.map&&(i.spotLightMap[E]=L.map,E++,H.updateMatrices(L),L.castShadow&&T++),i.spotLightMatrix[v]=H.matrix,L.castShadow){let ie=t.get(L);ie.shadowIntensity=H.intensity,ie.shadowBias=H.bias,ie.shadowNormalBias=H.normalBias,ie.shadowRadius=H.radius,ie.shadowMapSize=H.mapSize,i.spotShadow[v]=ie,i.spotShadowMap[v]=O,b++}v++}else if(L.isRectAreaLight){let Y=e.get(L);Y.color.copy(U).multiplyScalar(G),Y.halfWidth.set(L.width*.5,0,0),Y.halfHeight.set(0,L.height*.5,0),i.rectArea[g]=Y,g++}else if(L.isPointLight){let Y=e.get(L);if(Y.color.copy(L.color).multiplyScalar(L.intensity),Y.distance=L.distance,Y.decay=L.decay,L.castShadow){let H=L.shadow,ie=t.get(L);ie.shadowIntensity=H.intensity,ie.shadowBias=H.bias,ie.shadowNormalBias=H.normalBias,ie.shadowRadius=H.radius,ie.shadowMapSize=H.mapSize,ie.shadowCameraNear=H.camera.near,ie.shadowCameraFar=H.camera.far,i.pointShadow[m]=ie,i.pointShadowMap[m]=O,i.pointShadowMatrix[m]=L.shadow.matrix,C++}i.point[m]=Y,m++}else if(L.isHemisphereLight){let Y=e.get(L);Y.skyColor.copy(L.color).multiplyScalar(G),Y.groundColor.copy(L.groundColor).multiplyScalar(G),i.hemi[p]=Y,p++}}g>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ee.LTC_FLOAT_1,i.rectAreaLTC2=Ee.LTC_FLOAT_2):(i.rectAreaLTC1=Ee.LTC_HALF_1,i.rectAreaLTC2=Ee.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=d,i.ambient[2]=h;let y=i.hash;(y.directionalLength!==f||y.pointLength!==m||y.spotLength!==v||y.rectAreaLength!==g||y.hemiLength!==p||y.numDirectionalShadows!==S||y.numPointShadows!==C||y.numSpotShadows!==b||y.numSpotMaps!==E||y.numLightProbes!==D)&&(i.directional.length=f,i.spot.length=v,i.rectArea.length=g,i.point.length=m,i.hemi.length=p,i.directionalShadow.length=S,i.directionalShadowMap.length=S,i.pointShadow.length=C,i.pointShadowMap.length=C,i.spotShadow.length=b,i.spotShadowMap.length=b,i.directionalShadowMatrix.length=S,i.pointShadowMatrix.length=C,i.spotLightMatrix.length=b+E-T,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=T,i.numLightProbes=D,y.directionalLength=f,y.pointLength=m,y.spotLength=v,y.rectAreaLength=g,y.hemiLength=p,y.numDirectionalShadows=S,y.numPointShadows=C,y.numSpotShadows=b,y.numSpotMaps=E,y.numLightProbes=D,i.version=kE++)}function l(c,u){let d=0,h=0,f=0,m=0,v=0,g=u.matrixWorldInverse;for(let p=0,S=c.length;p<S;p++){let C=c[p];if(C.isDirectionalLight){let b=i.directional[d];b.direction.setFromMatrixPosition(C.matrixWorld),s.setFromMatrixPosition(C.target.matrixWorld),b.direction.sub(s),b.direction.transformDirection(g),d++}else if(C.isSpotLight){let b=i.spot[f];b.position.setFromMatrixPosition(C.matrixWorld),b.position.applyMatrix4(g),b.direction.setFromMatrixPosition(C.matrixWorld),s.setFromMatrixPosition(C.target.matrixWorld),b.direction.sub(s),b.direction.transformDirection(g),f++}else if(C.isRectAreaLight){let b=i.rectArea[m];b.position.setFromMatrixPosition(C.matrixWorld),b.position.applyMatrix4(g),o.identity(),r.copy(C.matrixWorld),r.premultiply(g),o.extractRotation(r),b.halfWidth.set(C.width*.5,0,0),b.halfHeight.set(0,C.height*.5,0),b.halfWidth.applyMatrix4(o),b.halfHeight.applyMatrix4(o),m++}else if(C.isPointLight){let b=i.point[h];b.position.setFromMatrixPosition(C.matrixWorld),b.position.applyMatrix4(g),h++}else if(C.isHemisphereLight){let b=i.hemi[v];b.direction.setFromMatrixPosition(C.matrixWorld),b.direction.transformDirection(g),v++}}}return{setup:a,setupView:l,state:i}}function px(n){let e=new zE(n),t=[],i=[],s=[];function r(h){d.camera=h,t.length=0,i.length=0,s.length=0}function o(h){t.push(h)}function a(h){i.push(h)}function l(h){s.push(h)}function c(){e.setup(t)}function u(h){e.setupView(t,h)}let d={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:d,setupLights:c,setupLightsView:u,pushLight:o,pushShadow:a,pushLightProbeGrid:l}}function GE(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new px(n),e.set(s,[a])):r>=o.length?(a=new px(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var HE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,WE=`uniform sampler2D shadow_pass;
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
}`,XE=[new z(1,0,0),new z(-1,0,0),new z(0,1,0),new z(0,-1,0),new z(0,0,1),new z(0,0,-1)],qE=[new z(0,-1,0),new z(0,-1,0),new z(0,0,1),new z(0,0,-1),new z(0,-1,0),new z(0,-1,0)],mx=new Vt,dl=new z,Hf=new z;function YE(n,e,t){let i=new Ya,s=new je,r=new je,o=new jt,a=new iu,l=new su,c={},u=t.maxTextureSize,d={[$i]:ti,[ti]:$i,[ai]:ai},h=new an({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new je},radius:{value:4}},vertexShader:HE,fragmentShader:WE}),f=h.clone();f.defines.HORIZONTAL_PASS=1;let m=new yn;m.setAttribute("position",new ri(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Ot(m,h),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=nl;let p=this.type;this.render=function(T,D,y){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||T.length===0)return;this.type===h_&&(Ye("WebGLShadowMap: PCFSoftShadowMap has been deprecated. Using PCFShadowMap instead."),this.type=nl);let A=n.getRenderTarget(),F=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),U=n.state;U.setBlending(cs),U.buffers.depth.getReversed()===!0?U.buffers.color.setClear(0,0,0,0):U.buffers.color.setClear(1,1,1,1),U.buffers.depth.setTest(!0),U.setScissorTest(!1);let G=p!==this.type;G&&D.traverse(function(q){q.material&&(Array.isArray(q.material)?q.material.forEach(O=>O.needsUpdate=!0):q.material.needsUpdate=!0)});for(let q=0,O=T.length;q<O;q++){let Y=T[q],H=Y.shadow;if(H===void 0){Ye("WebGLShadowMap:",Y,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let ie=H.getFrameExtents();s.multiply(ie),r.copy(H.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ie.x),s.x=r.x*ie.x,H.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ie.y),s.y=r.y*ie.y,H.mapSize.y=r.y));let oe=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=oe,H.map===null||G===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===Ho){if(Y.isPointLight){Ye("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new Mi(s.x,s.y,{format:dr,type:us,minFilter:En,magFilter:En,generateMipmaps:!1}),H.map.texture.name=Y.name+".shadowMap",H.map.depthTexture=new As(s.x,s.y,Ei),H.map.depthTexture.name=Y.name+".shadowMapDepth",H.map.depthTexture.format=ls,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=vn,H.map.depthTexture.magFilter=vn}else Y.isPointLight?(H.map=new ah(s.x),H.map.depthTexture=new tu(s.x,Ji)):(H.map=new Mi(s.x,s.y),H.map.depthTexture=new As(s.x,s.y,Ji)),H.map.depthTexture.name=Y.name+".shadowMap",H.map.depthTexture.format=ls,this.type===nl?(H.map.depthTexture.compareFunction=oe?ih:nh,H.map.depthTexture.minFilter=En,H.map.depthTexture.magFilter=En):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=vn,H.map.depthTexture.magFilter=vn);H.camera.updateProjectionMatrix()}let le=H.map.isWebGLCubeRenderTarget?6:1;for(let de=0;de<le;de++){if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,de),n.clear();else{de===0&&(n.setRenderTarget(H.map),n.clear());let ue=H.getViewport(de);o.set(r.x*ue.x,r.y*ue.y,r.x*ue.z,r.y*ue.w),U.viewport(o)}if(Y.isPointLight){let ue=H.camera,_e=H.matrix,st=Y.distance||ue.far;st!==ue.far&&(ue.far=st,ue.updateProjectionMatrix()),dl.setFromMatrixPosition(Y.matrixWorld),ue.position.copy(dl),Hf.copy(ue.position),Hf.add(XE[de]),ue.up.copy(qE[de]),ue.lookAt(Hf),ue.updateMatrixWorld(),_e.makeTranslation(-dl.x,-dl.y,-dl.z),mx.multiplyMatrices(ue.projectionMatrix,ue.matrixWorldInverse),H._frustum.setFromProjectionMatrix(mx,ue.coordinateSystem,ue.reversedDepth)}else H.updateMatrices(Y);i=H.getFrustum(),b(D,y,H.camera,Y,this.type)}H.isPointLightShadow!==!0&&this.type===Ho&&S(H,y),H.needsUpdate=!1}p=this.type,g.needsUpdate=!1,n.setRenderTarget(A,F,L)};function S(T,D){let y=e.update(v);h.defines.VSM_SAMPLES!==T.blurSamples&&(h.defines.VSM_SAMPLES=T.blurSamples,f.defines.VSM_SAMPLES=T.blurSamples,h.needsUpdate=!0,f.needsUpdate=!0),T.mapPass===null&&(T.mapPass=new Mi(s.x,s.y,{format:dr,type:us})),h.uniforms.shadow_pass.value=T.map.depthTexture,h.uniforms.resolution.value=T.mapSize,h.uniforms.radius.value=T.radius,n.setRenderTarget(T.mapPass),n.clear(),n.renderBufferDirect(D,null,y,h,v,null),f.uniforms.shadow_pass.value=T.mapPass.texture,f.uniforms.resolution.value=T.mapSize,f.uniforms.radius.value=T.radius,n.setRenderTarget(T.map),n.clear(),n.renderBufferDirect(D,null,y,f,v,null)}function C(T,D,y,A){let F=null,L=y.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(L!==void 0)F=L;else if(F=y.isPointLight===!0?l:a,n.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0||D.alphaToCoverage===!0){let U=F.uuid,G=D.uuid,q=c[U];q===void 0&&(q={},c[U]=q);let O=q[G];O===void 0&&(O=F.clone(),q[G]=O,D.addEventListener("dispose",E)),F=O}if(F.visible=D.visible,F.wireframe=D.wireframe,A===Ho?F.side=D.shadowSide!==null?D.shadowSide:D.side:F.side=D.shadowSide!==null?D.shadowSide:d[D.side],F.alphaMap=D.alphaMap,F.alphaTest=D.alphaToCoverage===!0?.5:D.alphaTest,F.map=D.map,F.clipShadows=D.clipShadows,F.clippingPlanes=D.clippingPlanes,F.clipIntersection=D.clipIntersection,F.displacementMap=D.displacementMap,F.displacementScale=D.displacementScale,F.displacementBias=D.displacementBias,F.wireframeLinewidth=D.wireframeLinewidth,F.linewidth=D.linewidth,y.isPointLight===!0&&F.isMeshDistanceMaterial===!0){let U=n.properties.get(F);U.light=y}return F}function b(T,D,y,A,F){if(T.visible===!1)return;if(T.layers.test(D.layers)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&F===Ho)&&(!T.frustumCulled||i.intersectsObject(T))){T.modelViewMatrix.multiplyMatrices(y.matrixWorldInverse,T.matrixWorld);let G=e.update(T),q=T.material;if(Array.isArray(q)){let O=G.groups;for(let Y=0,H=O.length;Y<H;Y++){let ie=O[Y],oe=q[ie.materialIndex];if(oe&&oe.visible){let le=C(T,oe,A,F);T.onBeforeShadow(n,T,D,y,G,le,ie),n.renderBufferDirect(y,null,G,le,T,ie),T.onAfterShadow(n,T,D,y,G,le,ie)}}}else if(q.visible){let O=C(T,q,A,F);T.onBeforeShadow(n,T,D,y,G,O,null),n.renderBufferDirect(y,null,G,O,T,null),T.onAfterShadow(n,T,D,y,G,O,null)}}let U=T.children;for(let G=0,q=U.length;G<q;G++)b(U[G],D,y,A,F)}function E(T){T.target.removeEventListener("dispose",E);for(let y in c){let A=c[y],F=T.target.uuid;F in A&&(A[F].dispose(),delete A[F])}}}function $E(n,e){function t(){let k=!1,be=new jt,se=null,Se=new jt(0,0,0,0);return{setMask:function(Ae){se!==Ae&&!k&&(n.colorMask(Ae,Ae,Ae,Ae),se=Ae)},setLocked:function(Ae){k=Ae},setClear:function(Ae,ce,ze,Ne,lt){lt===!0&&(Ae*=Ne,ce*=Ne,ze*=Ne),be.set(Ae,ce,ze,Ne),Se.equals(be)===!1&&(n.clearColor(Ae,ce,ze,Ne),Se.copy(be))},reset:function(){k=!1,se=null,Se.set(-1,0,0,0)}}}function i(){let k=!1,be=!1,se=null,Se=null,Ae=null;return{setReversed:function(ce){if(be!==ce){let ze=e.get("EXT_clip_control");ce?ze.clipControlEXT(ze.LOWER_LEFT_EXT,ze.ZERO_TO_ONE_EXT):ze.clipControlEXT(ze.LOWER_LEFT_EXT,ze.NEGATIVE_ONE_TO_ONE_EXT),be=ce;let Ne=Ae;Ae=null,this.setClear(Ne)}},getReversed:function(){return be},setTest:function(ce){ce?he(n.DEPTH_TEST):Ve(n.DEPTH_TEST)},setMask:function(ce){se!==ce&&!k&&(n.depthMask(ce),se=ce)},setFunc:function(ce){if(be&&(ce=W_[ce]),Se!==ce){switch(ce){case Vc:n.depthFunc(n.NEVER);break;case zc:n.depthFunc(n.ALWAYS);break;case Gc:n.depthFunc(n.LESS);break;case Or:n.depthFunc(n.LEQUAL);break;case Hc:n.depthFunc(n.EQUAL);break;case Wc:n.depthFunc(n.GEQUAL);break;case Xc:n.depthFunc(n.GREATER);break;case qc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Se=ce}},setLocked:function(ce){k=ce},setClear:function(ce){Ae!==ce&&(Ae=ce,be&&(ce=1-ce),n.clearDepth(ce))},reset:function(){k=!1,se=null,Se=null,Ae=null,be=!1}}}function s(){let k=!1,be=null,se=null,Se=null,Ae=null,ce=null,ze=null,Ne=null,lt=null;return{setTest:function(ht){k||(ht?he(n.STENCIL_TEST):Ve(n.STENCIL_TEST))},setMask:function(ht){be!==ht&&!k&&(n.stencilMask(ht),be=ht)},setFunc:function(ht,Fn,Un){(se!==ht||Se!==Fn||Ae!==Un)&&(n.stencilFunc(ht,Fn,Un),se=ht,Se=Fn,Ae=Un)},setOp:function(ht,Fn,Un){(ce!==ht||ze!==Fn||Ne!==Un)&&(n.stencilOp(ht,Fn,Un),ce=ht,ze=Fn,Ne=Un)},setLocked:function(ht){k=ht},setClear:function(ht){lt!==ht&&(n.clearStencil(ht),lt=ht)},reset:function(){k=!1,be=null,se=null,Se=null,Ae=null,ce=null,ze=null,Ne=null,lt=null}}}let r=new t,o=new i,a=new s,l=new WeakMap,c=new WeakMap,u={},d={},h={},f=new WeakMap,m=[],v=null,g=!1,p=null,S=null,C=null,b=null,E=null,T=null,D=null,y=new xt(0,0,0),A=0,F=!1,L=null,U=null,G=null,q=null,O=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,ie=0,oe=n.getParameter(n.VERSION);oe.indexOf("WebGL")!==-1?(ie=parseFloat(/^WebGL (\d)/.exec(oe)[1]),H=ie>=1):oe.indexOf("OpenGL ES")!==-1&&(ie=parseFloat(/^OpenGL ES (\d)/.exec(oe)[1]),H=ie>=2);let le=null,de={},ue=n.getParameter(n.SCISSOR_BOX),_e=n.getParameter(n.VIEWPORT),st=new jt().fromArray(ue),Qe=new jt().fromArray(_e);function Q(k,be,se,Se){let Ae=new Uint8Array(4),ce=n.createTexture();n.bindTexture(k,ce),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let ze=0;ze<se;ze++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(be,0,n.RGBA,1,1,Se,0,n.RGBA,n.UNSIGNED_BYTE,Ae):n.texImage2D(be+ze,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Ae);return ce}let ae={};ae[n.TEXTURE_2D]=Q(n.TEXTURE_2D,n.TEXTURE_2D,1),ae[n.TEXTURE_CUBE_MAP]=Q(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),ae[n.TEXTURE_2D_ARRAY]=Q(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),ae[n.TEXTURE_3D]=Q(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),he(n.DEPTH_TEST),o.setFunc(Or),Xt(!1),Qt(cf),he(n.CULL_FACE),ct(cs);function he(k){u[k]!==!0&&(n.enable(k),u[k]=!0)}function Ve(k){u[k]!==!1&&(n.disable(k),u[k]=!1)}function De(k,be){return h[k]!==be?(n.bindFramebuffer(k,be),h[k]=be,k===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=be),k===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=be),!0):!1}function Be(k,be){let se=m,Se=!1;if(k){se=f.get(be),se===void 0&&(se=[],f.set(be,se));let Ae=k.textures;if(se.length!==Ae.length||se[0]!==n.COLOR_ATTACHMENT0){for(let ce=0,ze=Ae.length;ce<ze;ce++)se[ce]=n.COLOR_ATTACHMENT0+ce;se.length=Ae.length,Se=!0}}else se[0]!==n.BACK&&(se[0]=n.BACK,Se=!0);Se&&n.drawBuffers(se)}function St(k){return v!==k?(n.useProgram(k),v=k,!0):!1}let $e={[er]:n.FUNC_ADD,[f_]:n.FUNC_SUBTRACT,[p_]:n.FUNC_REVERSE_SUBTRACT};$e[m_]=n.MIN,$e[g_]=n.MAX;let ft={[__]:n.ZERO,[x_]:n.ONE,[v_]:n.SRC_COLOR,[Bc]:n.SRC_ALPHA,[T_]:n.SRC_ALPHA_SATURATE,[S_]:n.DST_COLOR,[b_]:n.DST_ALPHA,[y_]:n.ONE_MINUS_SRC_COLOR,[kc]:n.ONE_MINUS_SRC_ALPHA,[w_]:n.ONE_MINUS_DST_COLOR,[M_]:n.ONE_MINUS_DST_ALPHA,[E_]:n.CONSTANT_COLOR,[A_]:n.ONE_MINUS_CONSTANT_COLOR,[C_]:n.CONSTANT_ALPHA,[R_]:n.ONE_MINUS_CONSTANT_ALPHA};function ct(k,be,se,Se,Ae,ce,ze,Ne,lt,ht){if(k===cs){g===!0&&(Ve(n.BLEND),g=!1);return}if(g===!1&&(he(n.BLEND),g=!0),k!==d_){if(k!==p||ht!==F){if((S!==er||E!==er)&&(n.blendEquation(n.FUNC_ADD),S=er,E=er),ht)switch(k){case Ur:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case uf:n.blendFunc(n.ONE,n.ONE);break;case hf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case df:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Je("WebGLState: Invalid blending: ",k);break}else switch(k){case Ur:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case uf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case hf:Je("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case df:Je("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Je("WebGLState: Invalid blending: ",k);break}C=null,b=null,T=null,D=null,y.set(0,0,0),A=0,p=k,F=ht}return}Ae=Ae||be,ce=ce||se,ze=ze||Se,(be!==S||Ae!==E)&&(n.blendEquationSeparate($e[be],$e[Ae]),S=be,E=Ae),(se!==C||Se!==b||ce!==T||ze!==D)&&(n.blendFuncSeparate(ft[se],ft[Se],ft[ce],ft[ze]),C=se,b=Se,T=ce,D=ze),(Ne.equals(y)===!1||lt!==A)&&(n.blendColor(Ne.r,Ne.g,Ne.b,lt),y.copy(Ne),A=lt),p=k,F=!1}function ot(k,be){k.side===ai?Ve(n.CULL_FACE):he(n.CULL_FACE);let se=k.side===ti;be&&(se=!se),Xt(se),k.blending===Ur&&k.transparent===!1?ct(cs):ct(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let Se=k.stencilWrite;a.setTest(Se),Se&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),vt(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?he(n.SAMPLE_ALPHA_TO_COVERAGE):Ve(n.SAMPLE_ALPHA_TO_COVERAGE)}function Xt(k){L!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),L=k)}function Qt(k){k!==c_?(he(n.CULL_FACE),k!==U&&(k===cf?n.cullFace(n.BACK):k===u_?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ve(n.CULL_FACE),U=k}function qt(k){k!==G&&(H&&n.lineWidth(k),G=k)}function vt(k,be,se){k?(he(n.POLYGON_OFFSET_FILL),(q!==be||O!==se)&&(q=be,O=se,o.getReversed()&&(be=-be),n.polygonOffset(be,se))):Ve(n.POLYGON_OFFSET_FILL)}function Lt(k){k?he(n.SCISSOR_TEST):Ve(n.SCISSOR_TEST)}function Ct(k){k===void 0&&(k=n.TEXTURE0+Y-1),le!==k&&(n.activeTexture(k),le=k)}function V(k,be,se){se===void 0&&(le===null?se=n.TEXTURE0+Y-1:se=le);let Se=de[se];Se===void 0&&(Se={type:void 0,texture:void 0},de[se]=Se),(Se.type!==k||Se.texture!==be)&&(le!==se&&(n.activeTexture(se),le=se),n.bindTexture(k,be||ae[k]),Se.type=k,Se.texture=be)}function We(){let k=de[le];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function fe(){try{n.compressedTexImage2D(...arguments)}catch(k){Je("WebGLState:",k)}}function R(){try{n.compressedTexImage3D(...arguments)}catch(k){Je("WebGLState:",k)}}function x(){try{n.texSubImage2D(...arguments)}catch(k){Je("WebGLState:",k)}}function X(){try{n.texSubImage3D(...arguments)}catch(k){Je("WebGLState:",k)}}function K(){try{n.compressedTexSubImage2D(...arguments)}catch(k){Je("WebGLState:",k)}}function ee(){try{n.compressedTexSubImage3D(...arguments)}catch(k){Je("WebGLState:",k)}}function me(){try{n.texStorage2D(...arguments)}catch(k){Je("WebGLState:",k)}}function ge(){try{n.texStorage3D(...arguments)}catch(k){Je("WebGLState:",k)}}function te(){try{n.texImage2D(...arguments)}catch(k){Je("WebGLState:",k)}}function ne(){try{n.texImage3D(...arguments)}catch(k){Je("WebGLState:",k)}}function xe(k){return d[k]!==void 0?d[k]:n.getParameter(k)}function ke(k,be){d[k]!==be&&(n.pixelStorei(k,be),d[k]=be)}function Me(k){st.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),st.copy(k))}function ye(k){Qe.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),Qe.copy(k))}function Oe(k,be){let se=c.get(be);se===void 0&&(se=new WeakMap,c.set(be,se));let Se=se.get(k);Se===void 0&&(Se=n.getUniformBlockIndex(be,k.name),se.set(k,Se))}function Xe(k,be){let Se=c.get(be).get(k);l.get(be)!==Se&&(n.uniformBlockBinding(be,Se,k.__bindingPointIndex),l.set(be,Se))}function qe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},d={},le=null,de={},h={},f=new WeakMap,m=[],v=null,g=!1,p=null,S=null,C=null,b=null,E=null,T=null,D=null,y=new xt(0,0,0),A=0,F=!1,L=null,U=null,G=null,q=null,O=null,st.set(0,0,n.canvas.width,n.canvas.height),Qe.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:he,disable:Ve,bindFramebuffer:De,drawBuffers:Be,useProgram:St,setBlending:ct,setMaterial:ot,setFlipSided:Xt,setCullFace:Qt,setLineWidth:qt,setPolygonOffset:vt,setScissorTest:Lt,activeTexture:Ct,bindTexture:V,unbindTexture:We,compressedTexImage2D:fe,compressedTexImage3D:R,texImage2D:te,texImage3D:ne,pixelStorei:ke,getParameter:xe,updateUBOMapping:Oe,uniformBlockBinding:Xe,texStorage2D:me,texStorage3D:ge,texSubImage2D:x,texSubImage3D:X,compressedTexSubImage2D:K,compressedTexSubImage3D:ee,scissor:Me,viewport:ye,reset:qe}}function ZE(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new je,u=new WeakMap,d=new Set,h,f=new WeakMap,m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function v(R,x){return m?new OffscreenCanvas(R,x):ka("canvas")}function g(R,x,X){let K=1,ee=fe(R);if((ee.width>X||ee.height>X)&&(K=X/Math.max(ee.width,ee.height)),K<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let me=Math.floor(K*ee.width),ge=Math.floor(K*ee.height);h===void 0&&(h=v(me,ge));let te=x?v(me,ge):h;return te.width=me,te.height=ge,te.getContext("2d").drawImage(R,0,0,me,ge),Ye("WebGLRenderer: Texture has been resized from ("+ee.width+"x"+ee.height+") to ("+me+"x"+ge+")."),te}else return"data"in R&&Ye("WebGLRenderer: Image in DataTexture is too big ("+ee.width+"x"+ee.height+")."),R;return R}function p(R){return R.generateMipmaps}function S(R){n.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function b(R,x,X,K,ee,me=!1){if(R!==null){if(n[R]!==void 0)return n[R];Ye("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ge;K&&(ge=e.get("EXT_texture_norm16"),ge||Ye("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=x;if(x===n.RED&&(X===n.FLOAT&&(te=n.R32F),X===n.HALF_FLOAT&&(te=n.R16F),X===n.UNSIGNED_BYTE&&(te=n.R8),X===n.UNSIGNED_SHORT&&ge&&(te=ge.R16_EXT),X===n.SHORT&&ge&&(te=ge.R16_SNORM_EXT)),x===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.R8UI),X===n.UNSIGNED_SHORT&&(te=n.R16UI),X===n.UNSIGNED_INT&&(te=n.R32UI),X===n.BYTE&&(te=n.R8I),X===n.SHORT&&(te=n.R16I),X===n.INT&&(te=n.R32I)),x===n.RG&&(X===n.FLOAT&&(te=n.RG32F),X===n.HALF_FLOAT&&(te=n.RG16F),X===n.UNSIGNED_BYTE&&(te=n.RG8),X===n.UNSIGNED_SHORT&&ge&&(te=ge.RG16_EXT),X===n.SHORT&&ge&&(te=ge.RG16_SNORM_EXT)),x===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RG8UI),X===n.UNSIGNED_SHORT&&(te=n.RG16UI),X===n.UNSIGNED_INT&&(te=n.RG32UI),X===n.BYTE&&(te=n.RG8I),X===n.SHORT&&(te=n.RG16I),X===n.INT&&(te=n.RG32I)),x===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RGB8UI),X===n.UNSIGNED_SHORT&&(te=n.RGB16UI),X===n.UNSIGNED_INT&&(te=n.RGB32UI),X===n.BYTE&&(te=n.RGB8I),X===n.SHORT&&(te=n.RGB16I),X===n.INT&&(te=n.RGB32I)),x===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),X===n.UNSIGNED_INT&&(te=n.RGBA32UI),X===n.BYTE&&(te=n.RGBA8I),X===n.SHORT&&(te=n.RGBA16I),X===n.INT&&(te=n.RGBA32I)),x===n.RGB&&(X===n.UNSIGNED_SHORT&&ge&&(te=ge.RGB16_EXT),X===n.SHORT&&ge&&(te=ge.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),x===n.RGBA){let ne=me?Oa:_t.getTransfer(ee);X===n.FLOAT&&(te=n.RGBA32F),X===n.HALF_FLOAT&&(te=n.RGBA16F),X===n.UNSIGNED_BYTE&&(te=ne===Pt?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&ge&&(te=ge.RGBA16_EXT),X===n.SHORT&&ge&&(te=ge.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function E(R,x){let X;return R?x===null||x===Ji||x===Xo?X=n.DEPTH24_STENCIL8:x===Ei?X=n.DEPTH32F_STENCIL8:x===Wo&&(X=n.DEPTH24_STENCIL8,Ye("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):x===null||x===Ji||x===Xo?X=n.DEPTH_COMPONENT24:x===Ei?X=n.DEPTH_COMPONENT32F:x===Wo&&(X=n.DEPTH_COMPONENT16),X}function T(R,x){return p(R)===!0||R.isFramebufferTexture&&R.minFilter!==vn&&R.minFilter!==En?Math.log2(Math.max(x.width,x.height))+1:R.mipmaps!==void 0&&R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?x.mipmaps.length:1}function D(R){let x=R.target;x.removeEventListener("dispose",D),A(x),x.isVideoTexture&&u.delete(x),x.isHTMLTexture&&d.delete(x)}function y(R){let x=R.target;x.removeEventListener("dispose",y),L(x)}function A(R){let x=i.get(R);if(x.__webglInit===void 0)return;let X=R.source,K=f.get(X);if(K){let ee=K[x.__cacheKey];ee.usedTimes--,ee.usedTimes===0&&F(R),Object.keys(K).length===0&&f.delete(X)}i.remove(R)}function F(R){let x=i.get(R);n.deleteTexture(x.__webglTexture);let X=R.source,K=f.get(X);delete K[x.__cacheKey],o.memory.textures--}function L(R){let x=i.get(R);if(R.depthTexture&&(R.depthTexture.dispose(),i.remove(R.depthTexture)),R.isWebGLCubeRenderTarget)for(let K=0;K<6;K++){if(Array.isArray(x.__webglFramebuffer[K]))for(let ee=0;ee<x.__webglFramebuffer[K].length;ee++)n.deleteFramebuffer(x.__webglFramebuffer[K][ee]);else n.deleteFramebuffer(x.__webglFramebuffer[K]);x.__webglDepthbuffer&&n.deleteRenderbuffer(x.__webglDepthbuffer[K])}else{if(Array.isArray(x.__webglFramebuffer))for(let K=0;K<x.__webglFramebuffer.length;K++)n.deleteFramebuffer(x.__webglFramebuffer[K]);else n.deleteFramebuffer(x.__webglFramebuffer);if(x.__webglDepthbuffer&&n.deleteRenderbuffer(x.__webglDepthbuffer),x.__webglMultisampledFramebuffer&&n.deleteFramebuffer(x.__webglMultisampledFramebuffer),x.__webglColorRenderbuffer)for(let K=0;K<x.__webglColorRenderbuffer.length;K++)x.__webglColorRenderbuffer[K]&&n.deleteRenderbuffer(x.__webglColorRenderbuffer[K]);x.__webglDepthRenderbuffer&&n.deleteRenderbuffer(x.__webglDepthRenderbuffer)}let X=R.textures;for(let K=0,ee=X.length;K<ee;K++){let me=i.get(X[K]);me.__webglTexture&&(n.deleteTexture(me.__webglTexture),o.memory.textures--),i.remove(X[K])}i.remove(R)}let U=0;function G(){U=0}function q(){return U}function O(R){U=R}function Y(){let R=U;return R>=s.maxTextures&&Ye("WebGLTextures: Trying to use "+R+" texture units while this GPU supports only "+s.maxTextures),U+=1,R}function H(R){let x=[];return x.push(R.wrapS),x.push(R.wrapT),x.push(R.wrapR||0),x.push(R.magFilter),x.push(R.minFilter),x.push(R.anisotropy),x.push(R.internalFormat),x.push(R.format),x.push(R.type),x.push(R.generateMipmaps),x.push(R.premultiplyAlpha),x.push(R.flipY),x.push(R.unpackAlignment),x.push(R.colorSpace),x.join()}function ie(R,x){let X=i.get(R);if(R.isVideoTexture&&V(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&X.__version!==R.version){let K=R.image;if(K===null)Ye("WebGLRenderer: Texture marked for update but no image data found.");else if(K.complete===!1)Ye("WebGLRenderer: Texture marked for update but image is incomplete");else{Ve(X,R,x);return}}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+x)}function oe(R,x){let X=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){Ve(X,R,x);return}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+x)}function le(R,x){let X=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){Ve(X,R,x);return}t.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+x)}function de(R,x){let X=i.get(R);if(R.isCubeDepthTexture!==!0&&R.version>0&&X.__version!==R.version){De(X,R,x);return}t.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+x)}let ue={[Yc]:n.REPEAT,[as]:n.CLAMP_TO_EDGE,[$c]:n.MIRRORED_REPEAT},_e={[vn]:n.NEAREST,[L_]:n.NEAREST_MIPMAP_NEAREST,[sl]:n.NEAREST_MIPMAP_LINEAR,[En]:n.LINEAR,[vu]:n.LINEAR_MIPMAP_NEAREST,[ur]:n.LINEAR_MIPMAP_LINEAR},st={[F_]:n.NEVER,[V_]:n.ALWAYS,[U_]:n.LESS,[nh]:n.LEQUAL,[O_]:n.EQUAL,[ih]:n.GEQUAL,[B_]:n.GREATER,[k_]:n.NOTEQUAL};function Qe(R,x){if(x.type===Ei&&e.has("OES_texture_float_linear")===!1&&(x.magFilter===En||x.magFilter===vu||x.magFilter===sl||x.magFilter===ur||x.minFilter===En||x.minFilter===vu||x.minFilter===sl||x.minFilter===ur)&&Ye("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,ue[x.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,ue[x.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,ue[x.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,_e[x.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,_e[x.minFilter]),x.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,st[x.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(x.magFilter===vn||x.minFilter!==sl&&x.minFilter!==ur||x.type===Ei&&e.has("OES_texture_float_linear")===!1)return;if(x.anisotropy>1||i.get(x).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(x.anisotropy,s.getMaxAnisotropy())),i.get(x).__currentAnisotropy=x.anisotropy}}}function Q(R,x){let X=!1;R.__webglInit===void 0&&(R.__webglInit=!0,x.addEventListener("dispose",D));let K=x.source,ee=f.get(K);ee===void 0&&(ee={},f.set(K,ee));let me=H(x);if(me!==R.__cacheKey){ee[me]===void 0&&(ee[me]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),ee[me].usedTimes++;let ge=ee[R.__cacheKey];ge!==void 0&&(ee[R.__cacheKey].usedTimes--,ge.usedTimes===0&&F(x)),R.__cacheKey=me,R.__webglTexture=ee[me].texture}return X}function ae(R,x,X){return Math.floor(Math.floor(R/X)/x)}function he(R,x,X,K){let me=R.updateRanges;if(me.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,x.width,x.height,X,K,x.data);else{me.sort((ke,Me)=>ke.start-Me.start);let ge=0;for(let ke=1;ke<me.length;ke++){let Me=me[ge],ye=me[ke],Oe=Me.start+Me.count,Xe=ae(ye.start,x.width,4),qe=ae(Me.start,x.width,4);ye.start<=Oe+1&&Xe===qe&&ae(ye.start+ye.count-1,x.width,4)===Xe?Me.count=Math.max(Me.count,ye.start+ye.count-Me.start):(++ge,me[ge]=ye)}me.length=ge+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),ne=t.getParameter(n.UNPACK_SKIP_PIXELS),xe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,x.width);for(let ke=0,Me=me.length;ke<Me;ke++){let ye=me[ke],Oe=Math.floor(ye.start/4),Xe=Math.ceil(ye.count/4),qe=Oe%x.width,k=Math.floor(Oe/x.width),be=Xe,se=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,qe),t.pixelStorei(n.UNPACK_SKIP_ROWS,k),t.texSubImage2D(n.TEXTURE_2D,0,qe,k,be,se,X,K,x.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ne),t.pixelStorei(n.UNPACK_SKIP_ROWS,xe)}}function Ve(R,x,X){let K=n.TEXTURE_2D;(x.isDataArrayTexture||x.isCompressedArrayTexture)&&(K=n.TEXTURE_2D_ARRAY),x.isData3DTexture&&(K=n.TEXTURE_3D);let ee=Q(R,x),me=x.source;t.bindTexture(K,R.__webglTexture,n.TEXTURE0+X);let ge=i.get(me);if(me.version!==ge.__version||ee===!0){if(t.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&x.image instanceof ImageBitmap)===!1){let se=_t.getPrimaries(_t.workingColorSpace),Se=x.colorSpace===Ps?null:_t.getPrimaries(x.colorSpace),Ae=x.colorSpace===Ps||se===Se?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,x.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ae)}t.pixelStorei(n.UNPACK_ALIGNMENT,x.unpackAlignment);let ne=g(x.image,!1,s.maxTextureSize);ne=We(x,ne);let xe=r.convert(x.format,x.colorSpace),ke=r.convert(x.type),Me=b(x.internalFormat,xe,ke,x.normalized,x.colorSpace,x.isVideoTexture);Qe(K,x);let ye,Oe=x.mipmaps,Xe=x.isVideoTexture!==!0,qe=ge.__version===void 0||ee===!0,k=me.dataReady,be=T(x,ne);if(x.isDepthTexture)Me=E(x.format===hr,x.type),qe&&(Xe?t.texStorage2D(n.TEXTURE_2D,1,Me,ne.width,ne.height):t.texImage2D(n.TEXTURE_2D,0,Me,ne.width,ne.height,0,xe,ke,null));else if(x.isDataTexture)if(Oe.length>0){Xe&&qe&&t.texStorage2D(n.TEXTURE_2D,be,Me,Oe[0].width,Oe[0].height);for(let se=0,Se=Oe.length;se<Se;se++)ye=Oe[se],Xe?k&&t.texSubImage2D(n.TEXTURE_2D,se,0,0,ye.width,ye.height,xe,ke,ye.data):t.texImage2D(n.TEXTURE_2D,se,Me,ye.width,ye.height,0,xe,ke,ye.data);x.generateMipmaps=!1}else Xe?(qe&&t.texStorage2D(n.TEXTURE_2D,be,Me,ne.width,ne.height),k&&he(x,ne,xe,ke)):t.texImage2D(n.TEXTURE_2D,0,Me,ne.width,ne.height,0,xe,ke,ne.data);else if(x.isCompressedTexture)if(x.isCompressedArrayTexture){Xe&&qe&&t.texStorage3D(n.TEXTURE_2D_ARRAY,be,Me,Oe[0].width,Oe[0].height,ne.depth);for(let se=0,Se=Oe.length;se<Se;se++)if(ye=Oe[se],x.format!==ni)if(xe!==null)if(Xe){if(k)if(x.layerUpdates.size>0){let Ae=Of(ye.width,ye.height,x.format,x.type);for(let ce of x.layerUpdates){let ze=ye.data.subarray(ce*Ae/ye.data.BYTES_PER_ELEMENT,(ce+1)*Ae/ye.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,se,0,0,ce,ye.width,ye.height,1,xe,ze)}x.clearLayerUpdates()}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,se,0,0,0,ye.width,ye.height,ne.depth,xe,ye.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,se,Me,ye.width,ye.height,ne.depth,0,ye.data,0,0);else Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Xe?k&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,se,0,0,0,ye.width,ye.height,ne.depth,xe,ke,ye.data):t.texImage3D(n.TEXTURE_2D_ARRAY,se,Me,ye.width,ye.height,ne.depth,0,xe,ke,ye.data)}else{Xe&&qe&&t.texStorage2D(n.TEXTURE_2D,be,Me,Oe[0].width,Oe[0].height);for(let se=0,Se=Oe.length;se<Se;se++)ye=Oe[se],x.format!==ni?xe!==null?Xe?k&&t.compressedTexSubImage2D(n.TEXTURE_2D,se,0,0,ye.width,ye.height,xe,ye.data):t.compressedTexImage2D(n.TEXTURE_2D,se,Me,ye.width,ye.height,0,ye.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Xe?k&&t.texSubImage2D(n.TEXTURE_2D,se,0,0,ye.width,ye.height,xe,ke,ye.data):t.texImage2D(n.TEXTURE_2D,se,Me,ye.width,ye.height,0,xe,ke,ye.data)}else if(x.isDataArrayTexture)if(Xe){if(qe&&t.texStorage3D(n.TEXTURE_2D_ARRAY,be,Me,ne.width,ne.height,ne.depth),k)if(x.layerUpdates.size>0){let se=Of(ne.width,ne.height,x.format,x.type);for(let Se of x.layerUpdates){let Ae=ne.data.subarray(Se*se/ne.data.BYTES_PER_ELEMENT,(Se+1)*se/ne.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Se,ne.width,ne.height,1,xe,ke,Ae)}x.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ne.width,ne.height,ne.depth,xe,ke,ne.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,Me,ne.width,ne.height,ne.depth,0,xe,ke,ne.data);else if(x.isData3DTexture)Xe?(qe&&t.texStorage3D(n.TEXTURE_3D,be,Me,ne.width,ne.height,ne.depth),k&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ne.width,ne.height,ne.depth,xe,ke,ne.data)):t.texImage3D(n.TEXTURE_3D,0,Me,ne.width,ne.height,ne.depth,0,xe,ke,ne.data);else if(x.isFramebufferTexture){if(qe)if(Xe)t.texStorage2D(n.TEXTURE_2D,be,Me,ne.width,ne.height);else{let se=ne.width,Se=ne.height;for(let Ae=0;Ae<be;Ae++)t.texImage2D(n.TEXTURE_2D,Ae,Me,se,Se,0,xe,ke,null),se>>=1,Se>>=1}}else if(x.isHTMLTexture){if("texElementImage2D"in n){let se=n.canvas;if(se.hasAttribute("layoutsubtree")||se.setAttribute("layoutsubtree","true"),ne.parentNode!==se){se.appendChild(ne),d.add(x),se.onpaint=Se=>{let Ae=Se.changedElements;for(let ce of d)Ae.includes(ce.image)&&(ce.needsUpdate=!0)},se.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ne);else{let Ae=n.RGBA,ce=n.RGBA,ze=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Ae,ce,ze,ne)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Oe.length>0){if(Xe&&qe){let se=fe(Oe[0]);t.texStorage2D(n.TEXTURE_2D,be,Me,se.width,se.height)}for(let se=0,Se=Oe.length;se<Se;se++)ye=Oe[se],Xe?k&&t.texSubImage2D(n.TEXTURE_2D,se,0,0,xe,ke,ye):t.texImage2D(n.TEXTURE_2D,se,Me,xe,ke,ye);x.generateMipmaps=!1}else if(Xe){if(qe){let se=fe(ne);t.texStorage2D(n.TEXTURE_2D,be,Me,se.width,se.height)}k&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,xe,ke,ne)}else t.texImage2D(n.TEXTURE_2D,0,Me,xe,ke,ne);p(x)&&S(K),ge.__version=me.version,x.onUpdate&&x.onUpdate(x)}R.__version=x.version}function De(R,x,X){if(x.image.length!==6)return;let K=Q(R,x),ee=x.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+X);let me=i.get(ee);if(ee.version!==me.__version||K===!0){t.activeTexture(n.TEXTURE0+X);let ge=_t.getPrimaries(_t.workingColorSpace),te=x.colorSpace===Ps?null:_t.getPrimaries(x.colorSpace),ne=x.colorSpace===Ps||ge===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,x.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,x.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne);let xe=x.isCompressedTexture||x.image[0].isCompressedTexture,ke=x.image[0]&&x.image[0].isDataTexture,Me=[];for(let ce=0;ce<6;ce++)!xe&&!ke?Me[ce]=g(x.image[ce],!0,s.maxCubemapSize):Me[ce]=ke?x.image[ce].image:x.image[ce],Me[ce]=We(x,Me[ce]);let ye=Me[0],Oe=r.convert(x.format,x.colorSpace),Xe=r.convert(x.type),qe=b(x.internalFormat,Oe,Xe,x.normalized,x.colorSpace),k=x.isVideoTexture!==!0,be=me.__version===void 0||K===!0,se=ee.dataReady,Se=T(x,ye);Qe(n.TEXTURE_CUBE_MAP,x);let Ae;if(xe){k&&be&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Se,qe,ye.width,ye.height);for(let ce=0;ce<6;ce++){Ae=Me[ce].mipmaps;for(let ze=0;ze<Ae.length;ze++){let Ne=Ae[ze];x.format!==ni?Oe!==null?k?se&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze,0,0,Ne.width,Ne.height,Oe,Ne.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze,qe,Ne.width,Ne.height,0,Ne.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):k?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze,0,0,Ne.width,Ne.height,Oe,Xe,Ne.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze,qe,Ne.width,Ne.height,0,Oe,Xe,Ne.data)}}}else{if(Ae=x.mipmaps,k&&be){Ae.length>0&&Se++;let ce=fe(Me[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Se,qe,ce.width,ce.height)}for(let ce=0;ce<6;ce++)if(ke){k?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,0,0,0,Me[ce].width,Me[ce].height,Oe,Xe,Me[ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,0,qe,Me[ce].width,Me[ce].height,0,Oe,Xe,Me[ce].data);for(let ze=0;ze<Ae.length;ze++){let lt=Ae[ze].image[ce].image;k?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze+1,0,0,lt.width,lt.height,Oe,Xe,lt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze+1,qe,lt.width,lt.height,0,Oe,Xe,lt.data)}}else{k?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,0,0,0,Oe,Xe,Me[ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,0,qe,Oe,Xe,Me[ce]);for(let ze=0;ze<Ae.length;ze++){let Ne=Ae[ze];k?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze+1,0,0,Oe,Xe,Ne.image[ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ce,ze+1,qe,Oe,Xe,Ne.image[ce])}}}p(x)&&S(n.TEXTURE_CUBE_MAP),me.__version=ee.version,x.onUpdate&&x.onUpdate(x)}R.__version=x.version}function Be(R,x,X,K,ee,me){let ge=r.convert(X.format,X.colorSpace),te=r.convert(X.type),ne=b(X.internalFormat,ge,te,X.normalized,X.colorSpace),xe=i.get(x),ke=i.get(X);if(ke.__renderTarget=x,!xe.__hasExternalTextures){let Me=Math.max(1,x.width>>me),ye=Math.max(1,x.height>>me);ee===n.TEXTURE_3D||ee===n.TEXTURE_2D_ARRAY?t.texImage3D(ee,me,ne,Me,ye,x.depth,0,ge,te,null):t.texImage2D(ee,me,ne,Me,ye,0,ge,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),Ct(x)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,K,ee,ke.__webglTexture,0,Lt(x)):(ee===n.TEXTURE_2D||ee>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ee<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,K,ee,ke.__webglTexture,me),t.bindFramebuffer(n.FRAMEBUFFER,null)}function St(R,x,X){if(n.bindRenderbuffer(n.RENDERBUFFER,R),x.depthBuffer){let K=x.depthTexture,ee=K&&K.isDepthTexture?K.type:null,me=E(x.stencilBuffer,ee),ge=x.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ct(x)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Lt(x),me,x.width,x.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,Lt(x),me,x.width,x.height):n.renderbufferStorage(n.RENDERBUFFER,me,x.width,x.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ge,n.RENDERBUFFER,R)}else{let K=x.textures;for(let ee=0;ee<K.length;ee++){let me=K[ee],ge=r.convert(me.format,me.colorSpace),te=r.convert(me.type),ne=b(me.internalFormat,ge,te,me.normalized,me.colorSpace);Ct(x)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Lt(x),ne,x.width,x.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,Lt(x),ne,x.width,x.height):n.renderbufferStorage(n.RENDERBUFFER,ne,x.width,x.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function $e(R,x,X){let K=x.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(x.depthTexture&&x.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ee=i.get(x.depthTexture);if(ee.__renderTarget=x,(!ee.__webglTexture||x.depthTexture.image.width!==x.width||x.depthTexture.image.height!==x.height)&&(x.depthTexture.image.width=x.width,x.depthTexture.image.height=x.height,x.depthTexture.needsUpdate=!0),K){if(ee.__webglInit===void 0&&(ee.__webglInit=!0,x.depthTexture.addEventListener("dispose",D)),ee.__webglTexture===void 0){ee.__webglTexture=n.createTexture(),t.bindTexture(n.TEXTURE_CUBE_MAP,ee.__webglTexture),Qe(n.TEXTURE_CUBE_MAP,x.depthTexture);let xe=r.convert(x.depthTexture.format),ke=r.convert(x.depthTexture.type),Me;x.depthTexture.format===ls?Me=n.DEPTH_COMPONENT24:x.depthTexture.format===hr&&(Me=n.DEPTH24_STENCIL8);for(let ye=0;ye<6;ye++)n.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ye,0,Me,x.width,x.height,0,xe,ke,null)}}else ie(x.depthTexture,0);let me=ee.__webglTexture,ge=Lt(x),te=K?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,ne=x.depthTexture.format===hr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(x.depthTexture.format===ls)Ct(x)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ne,te,me,0,ge):n.framebufferTexture2D(n.FRAMEBUFFER,ne,te,me,0);else if(x.depthTexture.format===hr)Ct(x)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ne,te,me,0,ge):n.framebufferTexture2D(n.FRAMEBUFFER,ne,te,me,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function ft(R){let x=i.get(R),X=R.isWebGLCubeRenderTarget===!0;if(x.__boundDepthTexture!==R.depthTexture){let K=R.depthTexture;if(x.__depthDisposeCallback&&x.__depthDisposeCallback(),K){let ee=()=>{delete x.__boundDepthTexture,delete x.__depthDisposeCallback,K.removeEventListener("dispose",ee)};K.addEventListener("dispose",ee),x.__depthDisposeCallback=ee}x.__boundDepthTexture=K}if(R.depthTexture&&!x.__autoAllocateDepthBuffer)if(X)for(let K=0;K<6;K++)$e(x.__webglFramebuffer[K],R,K);else{let K=R.texture.mipmaps;K&&K.length>0?$e(x.__webglFramebuffer[0],R,0):$e(x.__webglFramebuffer,R,0)}else if(X){x.__webglDepthbuffer=[];for(let K=0;K<6;K++)if(t.bindFramebuffer(n.FRAMEBUFFER,x.__webglFramebuffer[K]),x.__webglDepthbuffer[K]===void 0)x.__webglDepthbuffer[K]=n.createRenderbuffer(),St(x.__webglDepthbuffer[K],R,!1);else{let ee=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,me=x.__webglDepthbuffer[K];n.bindRenderbuffer(n.RENDERBUFFER,me),n.framebufferRenderbuffer(n.FRAMEBUFFER,ee,n.RENDERBUFFER,me)}}else{let K=R.texture.mipmaps;if(K&&K.length>0?t.bindFramebuffer(n.FRAMEBUFFER,x.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,x.__webglFramebuffer),x.__webglDepthbuffer===void 0)x.__webglDepthbuffer=n.createRenderbuffer(),St(x.__webglDepthbuffer,R,!1);else{let ee=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,me=x.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,me),n.framebufferRenderbuffer(n.FRAMEBUFFER,ee,n.RENDERBUFFER,me)}}t.bindFramebuffer(n.FRAMEBUFFER,null)}function ct(R,x,X){let K=i.get(R);x!==void 0&&Be(K.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&ft(R)}function ot(R){let x=R.texture,X=i.get(R),K=i.get(x);R.addEventListener("dispose",y);let ee=R.textures,me=R.isWebGLCubeRenderTarget===!0,ge=ee.length>1;if(ge||(K.__webglTexture===void 0&&(K.__webglTexture=n.createTexture()),K.__version=x.version,o.memory.textures++),me){X.__webglFramebuffer=[];for(let te=0;te<6;te++)if(x.mipmaps&&x.mipmaps.length>0){X.__webglFramebuffer[te]=[];for(let ne=0;ne<x.mipmaps.length;ne++)X.__webglFramebuffer[te][ne]=n.createFramebuffer()}else X.__webglFramebuffer[te]=n.createFramebuffer()}else{if(x.mipmaps&&x.mipmaps.length>0){X.__webglFramebuffer=[];for(let te=0;te<x.mipmaps.length;te++)X.__webglFramebuffer[te]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(ge)for(let te=0,ne=ee.length;te<ne;te++){let xe=i.get(ee[te]);xe.__webglTexture===void 0&&(xe.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&Ct(R)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let te=0;te<ee.length;te++){let ne=ee[te];X.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[te]);let xe=r.convert(ne.format,ne.colorSpace),ke=r.convert(ne.type),Me=b(ne.internalFormat,xe,ke,ne.normalized,ne.colorSpace,R.isXRRenderTarget===!0),ye=Lt(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ye,Me,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,X.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),St(X.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(me){t.bindTexture(n.TEXTURE_CUBE_MAP,K.__webglTexture),Qe(n.TEXTURE_CUBE_MAP,x);for(let te=0;te<6;te++)if(x.mipmaps&&x.mipmaps.length>0)for(let ne=0;ne<x.mipmaps.length;ne++)Be(X.__webglFramebuffer[te][ne],R,x,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,ne);else Be(X.__webglFramebuffer[te],R,x,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);p(x)&&S(n.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(ge){for(let te=0,ne=ee.length;te<ne;te++){let xe=ee[te],ke=i.get(xe),Me=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(Me=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(Me,ke.__webglTexture),Qe(Me,xe),Be(X.__webglFramebuffer,R,xe,n.COLOR_ATTACHMENT0+te,Me,0),p(xe)&&S(Me)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(te=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,K.__webglTexture),Qe(te,x),x.mipmaps&&x.mipmaps.length>0)for(let ne=0;ne<x.mipmaps.length;ne++)Be(X.__webglFramebuffer[ne],R,x,n.COLOR_ATTACHMENT0,te,ne);else Be(X.__webglFramebuffer,R,x,n.COLOR_ATTACHMENT0,te,0);p(x)&&S(te),t.unbindTexture()}R.depthBuffer&&ft(R)}function Xt(R){let x=R.textures;for(let X=0,K=x.length;X<K;X++){let ee=x[X];if(p(ee)){let me=C(R),ge=i.get(ee).__webglTexture;t.bindTexture(me,ge),S(me),t.unbindTexture()}}}let Qt=[],qt=[];function vt(R){if(R.samples>0){if(Ct(R)===!1){let x=R.textures,X=R.width,K=R.height,ee=n.COLOR_BUFFER_BIT,me=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ge=i.get(R),te=x.length>1;if(te)for(let xe=0;xe<x.length;xe++)t.bindFramebuffer(n.FRAMEBUFFER,ge.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ge.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ge.__webglMultisampledFramebuffer);let ne=R.texture.mipmaps;ne&&ne.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ge.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ge.__webglFramebuffer);for(let xe=0;xe<x.length;xe++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(ee|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(ee|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ge.__webglColorRenderbuffer[xe]);let ke=i.get(x[xe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,ke,0)}n.blitFramebuffer(0,0,X,K,0,0,X,K,ee,n.NEAREST),l===!0&&(Qt.length=0,qt.length=0,Qt.push(n.COLOR_ATTACHMENT0+xe),R.depthBuffer&&R.resolveDepthBuffer===!1&&(Qt.push(me),qt.push(me),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,qt)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Qt))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let xe=0;xe<x.length;xe++){t.bindFramebuffer(n.FRAMEBUFFER,ge.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.RENDERBUFFER,ge.__webglColorRenderbuffer[xe]);let ke=i.get(x[xe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ge.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.TEXTURE_2D,ke,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ge.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.resolveDepthBuffer===!1&&l){let x=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[x])}}}function Lt(R){return Math.min(s.maxSamples,R.samples)}function Ct(R){let x=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&x.__useRenderToTexture!==!1}function V(R){let x=o.render.frame;u.get(R)!==x&&(u.set(R,x),R.update())}function We(R,x){let X=R.colorSpace,K=R.format,ee=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||X!==Ua&&X!==Ps&&(_t.getTransfer(X)===Pt?(K!==ni||ee!==Ti)&&Ye("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Je("WebGLTextures: Unsupported texture color space:",X)),x}function fe(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=Y,this.resetTextureUnits=G,this.getTextureUnits=q,this.setTextureUnits=O,this.setTexture2D=ie,this.setTexture2DArray=oe,this.setTexture3D=le,this.setTextureCube=de,this.rebindTextures=ct,this.setupRenderTarget=ot,this.updateRenderTargetMipmap=Xt,this.updateMultisampleRenderTarget=vt,this.setupDepthRenderbuffer=ft,this.setupFrameBufferTexture=Be,this.useMultisampledRTT=Ct,this.isReversedDepthBuffer=function(){return t.buffers.depth.getReversed()}}function KE(n,e){function t(i,s=Ps){let r,o=_t.getTransfer(s);if(i===Ti)return n.UNSIGNED_BYTE;if(i===bu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Mu)return n.UNSIGNED_SHORT_5_5_5_1;if(i===wf)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Tf)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Mf)return n.BYTE;if(i===Sf)return n.SHORT;if(i===Wo)return n.UNSIGNED_SHORT;if(i===yu)return n.INT;if(i===Ji)return n.UNSIGNED_INT;if(i===Ei)return n.FLOAT;if(i===us)return n.HALF_FLOAT;if(i===Ef)return n.ALPHA;if(i===Af)return n.RGB;if(i===ni)return n.RGBA;if(i===ls)return n.DEPTH_COMPONENT;if(i===hr)return n.DEPTH_STENCIL;if(i===Cf)return n.RED;if(i===Su)return n.RED_INTEGER;if(i===dr)return n.RG;if(i===wu)return n.RG_INTEGER;if(i===Tu)return n.RGBA_INTEGER;if(i===rl||i===ol||i===al||i===ll)if(o===Pt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===rl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===ol)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===al)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===ll)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===rl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===ol)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===al)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===ll)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Eu||i===Au||i===Cu||i===Ru)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Eu)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Au)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Cu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Ru)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Pu||i===Iu||i===Lu||i===Nu||i===Du||i===cl||i===Fu)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Pu||i===Iu)return o===Pt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Lu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Nu)return r.COMPRESSED_R11_EAC;if(i===Du)return r.COMPRESSED_SIGNED_R11_EAC;if(i===cl)return r.COMPRESSED_RG11_EAC;if(i===Fu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Uu||i===Ou||i===Bu||i===ku||i===Vu||i===zu||i===Gu||i===Hu||i===Wu||i===Xu||i===qu||i===Yu||i===$u||i===Zu)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Uu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Ou)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Bu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===ku)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Vu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===zu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Gu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Hu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Wu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Xu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===qu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Yu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===$u)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Zu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Ku||i===Ju||i===ju)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Ku)return o===Pt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Ju)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===ju)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Qu||i===eh||i===ul||i===th)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Qu)return r.COMPRESSED_RED_RGTC1_EXT;if(i===eh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===ul)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===th)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Xo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var JE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,jE=`
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

}`,Jf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Za(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new an({vertexShader:JE,fragmentShader:jE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Ot(new zr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},jf=class extends Zi{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,d=null,h=null,f=null,m=null,v=typeof XRWebGLBinding<"u",g=new Jf,p={},S=t.getContextAttributes(),C=null,b=null,E=[],T=[],D=new je,y=null,A=new Gn;A.viewport=new jt;let F=new Gn;F.viewport=new jt;let L=[A,F],U=new gu,G=null,q=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let ae=E[Q];return ae===void 0&&(ae=new ko,E[Q]=ae),ae.getTargetRaySpace()},this.getControllerGrip=function(Q){let ae=E[Q];return ae===void 0&&(ae=new ko,E[Q]=ae),ae.getGripSpace()},this.getHand=function(Q){let ae=E[Q];return ae===void 0&&(ae=new ko,E[Q]=ae),ae.getHandSpace()};function O(Q){let ae=T.indexOf(Q.inputSource);if(ae===-1)return;let he=E[ae];he!==void 0&&(he.update(Q.inputSource,Q.frame,c||o),he.dispatchEvent({type:Q.type,data:Q.inputSource}))}function Y(){s.removeEventListener("select",O),s.removeEventListener("selectstart",O),s.removeEventListener("selectend",O),s.removeEventListener("squeeze",O),s.removeEventListener("squeezestart",O),s.removeEventListener("squeezeend",O),s.removeEventListener("end",Y),s.removeEventListener("inputsourceschange",H);for(let Q=0;Q<E.length;Q++){let ae=T[Q];ae!==null&&(T[Q]=null,E[Q].disconnect(ae))}G=null,q=null,g.reset();for(let Q in p)delete p[Q];e.setRenderTarget(C),f=null,h=null,d=null,s=null,b=null,Qe.stop(),i.isPresenting=!1,e.setPixelRatio(y),e.setSize(D.width,D.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,i.isPresenting===!0&&Ye("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,i.isPresenting===!0&&Ye("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return h!==null?h:f},this.getBinding=function(){return d===null&&v&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(C=e.getRenderTarget(),s.addEventListener("select",O),s.addEventListener("selectstart",O),s.addEventListener("selectend",O),s.addEventListener("squeeze",O),s.addEventListener("squeezestart",O),s.addEventListener("squeezeend",O),s.addEventListener("end",Y),s.addEventListener("inputsourceschange",H),S.xrCompatible!==!0&&await t.makeXRCompatible(),y=e.getPixelRatio(),e.getSize(D),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let he=null,Ve=null,De=null;S.depth&&(De=S.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,he=S.stencil?hr:ls,Ve=S.stencil?Xo:Ji);let Be={colorFormat:t.RGBA8,depthFormat:De,scaleFactor:r};d=this.getBinding(),h=d.createProjectionLayer(Be),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),b=new Mi(h.textureWidth,h.textureHeight,{format:ni,type:Ti,depthTexture:new As(h.textureWidth,h.textureHeight,Ve,void 0,void 0,void 0,void 0,void 0,void 0,he),stencilBuffer:S.stencil,colorSpace:e.outputColorSpace,samples:S.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1})}else{let he={antialias:S.antialias,alpha:!0,depth:S.depth,stencil:S.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,he),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new Mi(f.framebufferWidth,f.framebufferHeight,{format:ni,type:Ti,colorSpace:e.outputColorSpace,stencilBuffer:S.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Qe.setContext(s),Qe.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function H(Q){for(let ae=0;ae<Q.removed.length;ae++){let he=Q.removed[ae],Ve=T.indexOf(he);Ve>=0&&(T[Ve]=null,E[Ve].disconnect(he))}for(let ae=0;ae<Q.added.length;ae++){let he=Q.added[ae],Ve=T.indexOf(he);if(Ve===-1){for(let Be=0;Be<E.length;Be++)if(Be>=T.length){T.push(he),Ve=Be;break}else if(T[Be]===null){T[Be]=he,Ve=Be;break}if(Ve===-1)break}let De=E[Ve];De&&De.connect(he)}}let ie=new z,oe=new z;function le(Q,ae,he){ie.setFromMatrixPosition(ae.matrixWorld),oe.setFromMatrixPosition(he.matrixWorld);let Ve=ie.distanceTo(oe),De=ae.projectionMatrix.elements,Be=he.projectionMatrix.elements,St=De[14]/(De[10]-1),$e=De[14]/(De[10]+1),ft=(De[9]+1)/De[5],ct=(De[9]-1)/De[5],ot=(De[8]-1)/De[0],Xt=(Be[8]+1)/Be[0],Qt=St*ot,qt=St*Xt,vt=Ve/(-ot+Xt),Lt=vt*-ot;if(ae.matrixWorld.decompose(Q.position,Q.quaternion,Q.scale),Q.translateX(Lt),Q.translateZ(vt),Q.matrixWorld.compose(Q.position,Q.quaternion,Q.scale),Q.matrixWorldInverse.copy(Q.matrixWorld).invert(),De[10]===-1)Q.projectionMatrix.copy(ae.projectionMatrix),Q.projectionMatrixInverse.copy(ae.projectionMatrixInverse);else{let Ct=St+vt,V=$e+vt,We=Qt-Lt,fe=qt+(Ve-Lt),R=ft*$e/V*Ct,x=ct*$e/V*Ct;Q.projectionMatrix.makePerspective(We,fe,R,x,Ct,V),Q.projectionMatrixInverse.copy(Q.projectionMatrix).invert()}}function de(Q,ae){ae===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(ae.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let ae=Q.near,he=Q.far;g.texture!==null&&(g.depthNear>0&&(ae=g.depthNear),g.depthFar>0&&(he=g.depthFar)),U.near=F.near=A.near=ae,U.far=F.far=A.far=he,(G!==U.near||q!==U.far)&&(s.updateRenderState({depthNear:U.near,depthFar:U.far}),G=U.near,q=U.far),U.layers.mask=Q.layers.mask|6,A.layers.mask=U.layers.mask&-5,F.layers.mask=U.layers.mask&-3;let Ve=Q.parent,De=U.cameras;de(U,Ve);for(let Be=0;Be<De.length;Be++)de(De[Be],Ve);De.length===2?le(U,A,F):U.projectionMatrix.copy(A.projectionMatrix),ue(Q,U,Ve)};function ue(Q,ae,he){he===null?Q.matrix.copy(ae.matrixWorld):(Q.matrix.copy(he.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(ae.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(ae.projectionMatrix),Q.projectionMatrixInverse.copy(ae.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Oo*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return U},this.getFoveation=function(){if(!(h===null&&f===null))return l},this.setFoveation=function(Q){l=Q,h!==null&&(h.fixedFoveation=Q),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Q)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(U)},this.getCameraTexture=function(Q){return p[Q]};let _e=null;function st(Q,ae){if(u=ae.getViewerPose(c||o),m=ae,u!==null){let he=u.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let Ve=!1;he.length!==U.cameras.length&&(U.cameras.length=0,Ve=!0);for(let $e=0;$e<he.length;$e++){let ft=he[$e],ct=null;if(f!==null)ct=f.getViewport(ft);else{let Xt=d.getViewSubImage(h,ft);ct=Xt.viewport,$e===0&&(e.setRenderTargetTextures(b,Xt.colorTexture,Xt.depthStencilTexture),e.setRenderTarget(b))}let ot=L[$e];ot===void 0&&(ot=new Gn,ot.layers.enable($e),ot.viewport=new jt,L[$e]=ot),ot.matrix.fromArray(ft.transform.matrix),ot.matrix.decompose(ot.position,ot.quaternion,ot.scale),ot.projectionMatrix.fromArray(ft.projectionMatrix),ot.projectionMatrixInverse.copy(ot.projectionMatrix).invert(),ot.viewport.set(ct.x,ct.y,ct.width,ct.height),$e===0&&(U.matrix.copy(ot.matrix),U.matrix.decompose(U.position,U.quaternion,U.scale)),Ve===!0&&U.cameras.push(ot)}let De=s.enabledFeatures;if(De&&De.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){d=i.getBinding();let $e=d.getDepthInformation(he[0]);$e&&$e.isValid&&$e.texture&&g.init($e,s.renderState)}if(De&&De.includes("camera-access")&&v){e.state.unbindTexture(),d=i.getBinding();for(let $e=0;$e<he.length;$e++){let ft=he[$e].camera;if(ft){let ct=p[ft];ct||(ct=new Za,p[ft]=ct);let ot=d.getCameraImage(ft);ct.sourceTexture=ot}}}}for(let he=0;he<E.length;he++){let Ve=T[he],De=E[he];Ve!==null&&De!==void 0&&De.update(Ve,ae,c||o)}_e&&_e(Q,ae),ae.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ae}),m=null}let Qe=new gx;Qe.setAnimationLoop(st),this.setAnimationLoop=function(Q){_e=Q},this.dispose=function(){}}},QE=new Vt,Mx=new nt;Mx.set(-1,0,0,0,1,0,0,0,1);function eA(n,e){function t(g,p){g.matrixAutoUpdate===!0&&g.updateMatrix(),p.value.copy(g.matrix)}function i(g,p){p.color.getRGB(g.fogColor.value,Df(n)),p.isFog?(g.fogNear.value=p.near,g.fogFar.value=p.far):p.isFogExp2&&(g.fogDensity.value=p.density)}function s(g,p,S,C,b){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(g,p):p.isMeshLambertMaterial?(r(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(g,p),d(g,p)):p.isMeshPhongMaterial?(r(g,p),u(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(g,p),h(g,p),p.isMeshPhysicalMaterial&&f(g,p,b)):p.isMeshMatcapMaterial?(r(g,p),m(g,p)):p.isMeshDepthMaterial?r(g,p):p.isMeshDistanceMaterial?(r(g,p),v(g,p)):p.isMeshNormalMaterial?r(g,p):p.isLineBasicMaterial?(o(g,p),p.isLineDashedMaterial&&a(g,p)):p.isPointsMaterial?l(g,p,S,C):p.isSpriteMaterial?c(g,p):p.isShadowMaterial?(g.color.value.copy(p.color),g.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(g,p){g.opacity.value=p.opacity,p.color&&g.diffuse.value.copy(p.color),p.emissive&&g.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(g.map.value=p.map,t(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.bumpMap&&(g.bumpMap.value=p.bumpMap,t(p.bumpMap,g.bumpMapTransform),g.bumpScale.value=p.bumpScale,p.side===ti&&(g.bumpScale.value*=-1)),p.normalMap&&(g.normalMap.value=p.normalMap,t(p.normalMap,g.normalMapTransform),g.normalScale.value.copy(p.normalScale),p.side===ti&&g.normalScale.value.negate()),p.displacementMap&&(g.displacementMap.value=p.displacementMap,t(p.displacementMap,g.displacementMapTransform),g.displacementScale.value=p.displacementScale,g.displacementBias.value=p.displacementBias),p.emissiveMap&&(g.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,g.emissiveMapTransform)),p.specularMap&&(g.specularMap.value=p.specularMap,t(p.specularMap,g.specularMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest);let S=e.get(p),C=S.envMap,b=S.envMapRotation;C&&(g.envMap.value=C,g.envMapRotation.value.setFromMatrix4(QE.makeRotationFromEuler(b)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Mx),g.reflectivity.value=p.reflectivity,g.ior.value=p.ior,g.refractionRatio.value=p.refractionRatio),p.lightMap&&(g.lightMap.value=p.lightMap,g.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,g.lightMapTransform)),p.aoMap&&(g.aoMap.value=p.aoMap,g.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,g.aoMapTransform))}function o(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,p.map&&(g.map.value=p.map,t(p.map,g.mapTransform))}function a(g,p){g.dashSize.value=p.dashSize,g.totalSize.value=p.dashSize+p.gapSize,g.scale.value=p.scale}function l(g,p,S,C){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.size.value=p.size*S,g.scale.value=C*.5,p.map&&(g.map.value=p.map,t(p.map,g.uvTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function c(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.rotation.value=p.rotation,p.map&&(g.map.value=p.map,t(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function u(g,p){g.specular.value.copy(p.specular),g.shininess.value=Math.max(p.shininess,1e-4)}function d(g,p){p.gradientMap&&(g.gradientMap.value=p.gradientMap)}function h(g,p){g.metalness.value=p.metalness,p.metalnessMap&&(g.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,g.metalnessMapTransform)),g.roughness.value=p.roughness,p.roughnessMap&&(g.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,g.roughnessMapTransform)),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)}function f(g,p,S){g.ior.value=p.ior,p.sheen>0&&(g.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),g.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(g.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,g.sheenColorMapTransform)),p.sheenRoughnessMap&&(g.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,g.sheenRoughnessMapTransform))),p.clearcoat>0&&(g.clearcoat.value=p.clearcoat,g.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(g.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,g.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(g.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===ti&&g.clearcoatNormalScale.value.negate())),p.dispersion>0&&(g.dispersion.value=p.dispersion),p.iridescence>0&&(g.iridescence.value=p.iridescence,g.iridescenceIOR.value=p.iridescenceIOR,g.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],g.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(g.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,g.iridescenceMapTransform)),p.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),p.transmission>0&&(g.transmission.value=p.transmission,g.transmissionSamplerMap.value=S.texture,g.transmissionSamplerSize.value.set(S.width,S.height),p.transmissionMap&&(g.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,g.transmissionMapTransform)),g.thickness.value=p.thickness,p.thicknessMap&&(g.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=p.attenuationDistance,g.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(g.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(g.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=p.specularIntensity,g.specularColor.value.copy(p.specularColor),p.specularColorMap&&(g.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,g.specularColorMapTransform)),p.specularIntensityMap&&(g.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,p){p.matcap&&(g.matcap.value=p.matcap)}function v(g,p){let S=e.get(p).light;g.referencePosition.value.setFromMatrixPosition(S.matrixWorld),g.nearDistance.value=S.shadow.camera.near,g.farDistance.value=S.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function tA(n,e,t,i){let s={},r={},o=[],a=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function l(b,E){let T=E.program;i.uniformBlockBinding(b,T)}function c(b,E){let T=s[b.id];T===void 0&&(g(b),T=u(b),s[b.id]=T,b.addEventListener("dispose",S));let D=E.program;i.updateUBOMapping(b,D);let y=e.render.frame;r[b.id]!==y&&(h(b),r[b.id]=y)}function u(b){let E=d();b.__bindingPointIndex=E;let T=n.createBuffer(),D=b.__size,y=b.usage;return n.bindBuffer(n.UNIFORM_BUFFER,T),n.bufferData(n.UNIFORM_BUFFER,D,y),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,E,T),T}function d(){for(let b=0;b<a;b++)if(o.indexOf(b)===-1)return o.push(b),b;return Je("WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function h(b){let E=s[b.id],T=b.uniforms,D=b.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let y=0,A=T.length;y<A;y++){let F=T[y];if(Array.isArray(F))for(let L=0,U=F.length;L<U;L++)f(F[L],y,L,D);else f(F,y,0,D)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function f(b,E,T,D){if(v(b,E,T,D)===!0){let y=b.__offset,A=b.value;if(Array.isArray(A)){let F=0;for(let L=0;L<A.length;L++){let U=A[L],G=p(U);m(U,b.__data,F),typeof U!="number"&&typeof U!="boolean"&&!U.isMatrix3&&!ArrayBuffer.isView(U)&&(F+=G.storage/Float32Array.BYTES_PER_ELEMENT)}}else m(A,b.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,y,b.__data)}}function m(b,E,T){typeof b=="number"||typeof b=="boolean"?E[0]=b:b.isMatrix3?(E[0]=b.elements[0],E[1]=b.elements[1],E[2]=b.elements[2],E[3]=0,E[4]=b.elements[3],E[5]=b.elements[4],E[6]=b.elements[5],E[7]=0,E[8]=b.elements[6],E[9]=b.elements[7],E[10]=b.elements[8],E[11]=0):ArrayBuffer.isView(b)?E.set(new b.constructor(b.buffer,b.byteOffset,E.length)):b.toArray(E,T)}function v(b,E,T,D){let y=b.value,A=E+"_"+T;if(D[A]===void 0)return typeof y=="number"||typeof y=="boolean"?D[A]=y:ArrayBuffer.isView(y)?D[A]=y.slice():D[A]=y.clone(),!0;{let F=D[A];if(typeof y=="number"||typeof y=="boolean"){if(F!==y)return D[A]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(F.equals(y)===!1)return F.copy(y),!0}}return!1}function g(b){let E=b.uniforms,T=0,D=16;for(let A=0,F=E.length;A<F;A++){let L=Array.isArray(E[A])?E[A]:[E[A]];for(let U=0,G=L.length;U<G;U++){let q=L[U],O=Array.isArray(q.value)?q.value:[q.value];for(let Y=0,H=O.length;Y<H;Y++){let ie=O[Y],oe=p(ie),le=T%D,de=le%oe.boundary,ue=le+de;T+=de,ue!==0&&D-ue<oe.storage&&(T+=D-ue),q.__data=new Float32Array(oe.storage/Float32Array.BYTES_PER_ELEMENT),q.__offset=T,T+=oe.storage}}}let y=T%D;return y>0&&(T+=D-y),b.__size=T,b.__cache={},this}function p(b){let E={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(E.boundary=4,E.storage=4):b.isVector2?(E.boundary=8,E.storage=8):b.isVector3||b.isColor?(E.boundary=16,E.storage=12):b.isVector4?(E.boundary=16,E.storage=16):b.isMatrix3?(E.boundary=48,E.storage=48):b.isMatrix4?(E.boundary=64,E.storage=64):b.isTexture?Ye("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(b)?(E.boundary=16,E.storage=b.byteLength):Ye("WebGLRenderer: Unsupported uniform value type.",b),E}function S(b){let E=b.target;E.removeEventListener("dispose",S);let T=o.indexOf(E.__bindingPointIndex);o.splice(T,1),n.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function C(){for(let b in s)n.deleteBuffer(s[b]);o=[],s={},r={}}return{bind:l,update:c,dispose:C}}var nA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),hs=null;function iA(){return hs===null&&(hs=new Vr(nA,16,16,dr,us),hs.name="DFG_LUT",hs.minFilter=En,hs.magFilter=En,hs.wrapS=as,hs.wrapT=as,hs.generateMipmaps=!1,hs.needsUpdate=!0),hs}var lh=class{constructor(e={}){let{canvas:t=z_(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:h=!1,outputBufferType:f=Ti}=e;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let v=f,g=new Set([Tu,wu,Su]),p=new Set([Ti,Ji,Wo,Xo,bu,Mu]),S=new Uint32Array(4),C=new Int32Array(4),b=new z,E=null,T=null,D=[],y=[],A=null;this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Ki,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let F=this,L=!1,U=null,G=null,q=null,O=null;this._outputColorSpace=bi;let Y=0,H=0,ie=null,oe=-1,le=null,de=new jt,ue=new jt,_e=null,st=new xt(0),Qe=0,Q=t.width,ae=t.height,he=1,Ve=null,De=null,Be=new jt(0,0,Q,ae),St=new jt(0,0,Q,ae),$e=!1,ft=new Ya,ct=!1,ot=!1,Xt=new Vt,Qt=new z,qt=new jt,vt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Lt=!1;function Ct(){return ie===null?he:1}let V=i;function We(w,W){return t.getContext(w,W)}try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"185"}`),t.addEventListener("webglcontextlost",lt,!1),t.addEventListener("webglcontextrestored",ht,!1),t.addEventListener("webglcontextcreationerror",Fn,!1),V===null){let W="webgl2";if(V=We(W,w),V===null)throw We(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}}catch(w){throw Je("WebGLRenderer: "+w.message),w}let fe,R,x,X,K,ee,me,ge,te,ne,xe,ke,Me,ye,Oe,Xe,qe,k,be,se,Se,Ae,ce;function ze(){fe=new uT(V),fe.init(),Se=new KE(V,fe),R=new nT(V,fe,e,Se),x=new $E(V,fe),R.reversedDepthBuffer&&h&&x.buffers.depth.setReversed(!0),G=V.createFramebuffer(),q=V.createFramebuffer(),O=V.createFramebuffer(),X=new fT(V),K=new DE,ee=new ZE(V,fe,x,K,R,Se,X),me=new cT(F),ge=new _S(V),Ae=new eT(V,ge),te=new hT(V,ge,X,Ae),ne=new mT(V,te,ge,Ae,X),k=new pT(V,R,ee),Oe=new iT(K),xe=new NE(F,me,fe,R,Ae,Oe),ke=new eA(F,K),Me=new UE,ye=new GE(fe),qe=new Q1(F,me,x,ne,m,l),Xe=new YE(F,ne,R),ce=new tA(V,X,R,x),be=new tT(V,fe,X),se=new dT(V,fe,X),X.programs=xe.programs,F.capabilities=R,F.extensions=fe,F.properties=K,F.renderLists=Me,F.shadowMap=Xe,F.state=x,F.info=X}ze(),v!==Ti&&(A=new _T(v,t.width,t.height,a,s,r));let Ne=new jf(F,V);this.xr=Ne,this.getContext=function(){return V},this.getContextAttributes=function(){return V.getContextAttributes()},this.forceContextLoss=function(){let w=fe.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=fe.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return he},this.setPixelRatio=function(w){w!==void 0&&(he=w,this.setSize(Q,ae,!1))},this.getSize=function(w){return w.set(Q,ae)},this.setSize=function(w,W,j=!0){if(Ne.isPresenting){Ye("WebGLRenderer: Can't change size while VR device is presenting.");return}Q=w,ae=W,t.width=Math.floor(w*he),t.height=Math.floor(W*he),j===!0&&(t.style.width=w+"px",t.style.height=W+"px"),A!==null&&A.setSize(t.width,t.height),this.setViewport(0,0,w,W)},this.getDrawingBufferSize=function(w){return w.set(Q*he,ae*he).floor()},this.setDrawingBufferSize=function(w,W,j){Q=w,ae=W,he=j,t.width=Math.floor(w*j),t.height=Math.floor(W*j),this.setViewport(0,0,w,W)},this.setEffects=function(w){if(v===Ti){Je("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let W=0;W<w.length;W++)if(w[W].isOutputPass===!0){Ye("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}A.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(de)},this.getViewport=function(w){return w.copy(Be)},this.setViewport=function(w,W,j,$){w.isVector4?Be.set(w.x,w.y,w.z,w.w):Be.set(w,W,j,$),x.viewport(de.copy(Be).multiplyScalar(he).round())},this.getScissor=function(w){return w.copy(St)},this.setScissor=function(w,W,j,$){w.isVector4?St.set(w.x,w.y,w.z,w.w):St.set(w,W,j,$),x.scissor(ue.copy(St).multiplyScalar(he).round())},this.getScissorTest=function(){return $e},this.setScissorTest=function(w){x.setScissorTest($e=w)},this.setOpaqueSort=function(w){Ve=w},this.setTransparentSort=function(w){De=w},this.getClearColor=function(w){return w.copy(qe.getClearColor())},this.setClearColor=function(){qe.setClearColor(...arguments)},this.getClearAlpha=function(){return qe.getClearAlpha()},this.setClearAlpha=function(){qe.setClearAlpha(...arguments)},this.clear=function(w=!0,W=!0,j=!0){let $=0;if(w){let J=!1;if(ie!==null){let Te=ie.texture.format;J=g.has(Te)}if(J){let Te=ie.texture.type,Pe=p.has(Te),we=qe.getClearColor(),Ue=qe.getClearAlpha(),Ce=we.r,et=we.g,rt=we.b;Pe?(S[0]=Ce,S[1]=et,S[2]=rt,S[3]=Ue,V.clearBufferuiv(V.COLOR,0,S)):(C[0]=Ce,C[1]=et,C[2]=rt,C[3]=Ue,V.clearBufferiv(V.COLOR,0,C))}else $|=V.COLOR_BUFFER_BIT}W&&($|=V.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&($|=V.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&V.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),U=w},this.dispose=function(){t.removeEventListener("webglcontextlost",lt,!1),t.removeEventListener("webglcontextrestored",ht,!1),t.removeEventListener("webglcontextcreationerror",Fn,!1),qe.dispose(),Me.dispose(),ye.dispose(),K.dispose(),me.dispose(),ne.dispose(),Ae.dispose(),ce.dispose(),xe.dispose(),Ne.dispose(),Ne.removeEventListener("sessionstart",ml),Ne.removeEventListener("sessionend",gl),Xn.stop()};function lt(w){w.preventDefault(),If("WebGLRenderer: Context Lost."),L=!0}function ht(){If("WebGLRenderer: Context Restored."),L=!1;let w=X.autoReset,W=Xe.enabled,j=Xe.autoUpdate,$=Xe.needsUpdate,J=Xe.type;ze(),X.autoReset=w,Xe.enabled=W,Xe.autoUpdate=j,Xe.needsUpdate=$,Xe.type=J}function Fn(w){Je("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function Un(w){let W=w.target;W.removeEventListener("dispose",Un),ii(W)}function ii(w){Is(w),K.remove(w)}function Is(w){let W=K.get(w).programs;W!==void 0&&(W.forEach(function(j){xe.releaseProgram(j)}),w.isShaderMaterial&&xe.releaseShaderCache(w))}this.renderBufferDirect=function(w,W,j,$,J,Te){W===null&&(W=vt);let Pe=J.isMesh&&J.matrixWorld.determinantAffine()<0,we=mr(w,W,j,$,J);x.setMaterial($,Pe);let Ue=j.index,Ce=1;if($.wireframe===!0){if(Ue=te.getWireframeAttribute(j),Ue===void 0)return;Ce=2}let et=j.drawRange,rt=j.attributes.position,Ge=et.start*Ce,wt=(et.start+et.count)*Ce;Te!==null&&(Ge=Math.max(Ge,Te.start*Ce),wt=Math.min(wt,(Te.start+Te.count)*Ce)),Ue!==null?(Ge=Math.max(Ge,0),wt=Math.min(wt,Ue.count)):rt!=null&&(Ge=Math.max(Ge,0),wt=Math.min(wt,rt.count));let rn=wt-Ge;if(rn<0||rn===1/0)return;Ae.setup(J,$,we,j,Ue);let en,Nt=be;if(Ue!==null&&(en=ge.get(Ue),Nt=se,Nt.setIndex(en)),J.isMesh)$.wireframe===!0?(x.setLineWidth($.wireframeLinewidth*Ct()),Nt.setMode(V.LINES)):Nt.setMode(V.TRIANGLES);else if(J.isLine){let bn=$.linewidth;bn===void 0&&(bn=1),x.setLineWidth(bn*Ct()),J.isLineSegments?Nt.setMode(V.LINES):J.isLineLoop?Nt.setMode(V.LINE_LOOP):Nt.setMode(V.LINE_STRIP)}else J.isPoints?Nt.setMode(V.POINTS):J.isSprite&&Nt.setMode(V.TRIANGLES);if(J.isBatchedMesh)if(fe.get("WEBGL_multi_draw"))Nt.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let bn=J._multiDrawStarts,Ie=J._multiDrawCounts,qn=J._multiDrawCount,pt=Ue?ge.get(Ue).bytesPerElement:1,Bn=K.get($).currentProgram.getUniforms();for(let Yn=0;Yn<qn;Yn++)Bn.setValue(V,"_gl_DrawID",Yn),Nt.render(bn[Yn]/pt,Ie[Yn])}else if(J.isInstancedMesh)Nt.renderInstances(Ge,rn,J.count);else if(j.isInstancedBufferGeometry){let bn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ie=Math.min(j.instanceCount,bn);Nt.renderInstances(Ge,rn,Ie)}else Nt.render(Ge,rn)};function ps(w,W,j){w.transparent===!0&&w.side===ai&&w.forceSinglePass===!1?(w.side=ti,w.needsUpdate=!0,sn(w,W,j),w.side=$i,w.needsUpdate=!0,sn(w,W,j),w.side=ai):sn(w,W,j)}this.compile=function(w,W,j=null){j===null&&(j=w),T=ye.get(j),T.init(W),y.push(T),j.traverseVisible(function(J){J.isLight&&J.layers.test(W.layers)&&(T.pushLight(J),J.castShadow&&T.pushShadow(J))}),w!==j&&w.traverseVisible(function(J){J.isLight&&J.layers.test(W.layers)&&(T.pushLight(J),J.castShadow&&T.pushShadow(J))}),T.setupLights();let $=new Set;return w.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Te=J.material;if(Te)if(Array.isArray(Te))for(let Pe=0;Pe<Te.length;Pe++){let we=Te[Pe];ps(we,j,J),$.add(we)}else ps(Te,j,J),$.add(Te)}),T=y.pop(),$},this.compileAsync=function(w,W,j=null){let $=this.compile(w,W,j);return new Promise(J=>{function Te(){if($.forEach(function(Pe){K.get(Pe).currentProgram.isReady()&&$.delete(Pe)}),$.size===0){J(w);return}setTimeout(Te,10)}fe.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let qr=null;function pl(w){qr&&qr(w)}function ml(){Xn.stop()}function gl(){Xn.start()}let Xn=new gx;Xn.setAnimationLoop(pl),typeof self<"u"&&Xn.setContext(self),this.setAnimationLoop=function(w){qr=w,Ne.setAnimationLoop(w),w===null?Xn.stop():Xn.start()},Ne.addEventListener("sessionstart",ml),Ne.addEventListener("sessionend",gl),this.render=function(w,W){if(W!==void 0&&W.isCamera!==!0){Je("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;U!==null&&U.renderStart(w,W);let j=Ne.enabled===!0&&Ne.isPresenting===!0,$=A!==null&&(ie===null||j)&&A.begin(F,ie);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),Ne.enabled===!0&&Ne.isPresenting===!0&&(A===null||A.isCompositing()===!1)&&(Ne.cameraAutoUpdate===!0&&Ne.updateCamera(W),W=Ne.getCamera()),w.isScene===!0&&w.onBeforeRender(F,w,W,ie),T=ye.get(w,y.length),T.init(W),T.state.textureUnits=ee.getTextureUnits(),y.push(T),Xt.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),ft.setFromProjectionMatrix(Xt,Yi,W.reversedDepth),ot=this.localClippingEnabled,ct=Oe.init(this.clippingPlanes,ot),E=Me.get(w,D.length),E.init(),D.push(E),Ne.enabled===!0&&Ne.isPresenting===!0){let Pe=F.xr.getDepthSensingMesh();Pe!==null&&Qo(Pe,W,-1/0,F.sortObjects)}Qo(w,W,0,F.sortObjects),E.finish(),F.sortObjects===!0&&E.sort(Ve,De,W.reversedDepth),Lt=Ne.enabled===!1||Ne.isPresenting===!1||Ne.hasDepthSensing()===!1,Lt&&qe.addToRenderList(E,w),this.info.render.frame++,this.info.autoReset===!0&&this.info.reset(),ct===!0&&Oe.beginShadows();let J=T.state.shadowsArray;if(Xe.render(J,w,W),ct===!0&&Oe.endShadows(),($&&A.hasRenderPass())===!1){let Pe=E.opaque,we=E.transmissive;if(T.setupLights(),W.isArrayCamera){let Ue=W.cameras;if(we.length>0)for(let Ce=0,et=Ue.length;Ce<et;Ce++){let rt=Ue[Ce];ea(Pe,we,w,rt)}Lt&&qe.render(w);for(let Ce=0,et=Ue.length;Ce<et;Ce++){let rt=Ue[Ce];Ls(E,w,rt,rt.viewport)}}else we.length>0&&ea(Pe,we,w,W),Lt&&qe.render(w),Ls(E,w,W)}ie!==null&&H===0&&(ee.updateMultisampleRenderTarget(ie),ee.updateRenderTargetMipmap(ie)),$&&A.end(F),w.isScene===!0&&w.onAfterRender(F,w,W),Ae.resetDefaultState(),oe=-1,le=null,y.pop(),y.length>0?(T=y[y.length-1],ee.setTextureUnits(T.state.textureUnits),ct===!0&&Oe.setGlobalState(F.clippingPlanes,T.state.camera)):T=null,D.pop(),D.length>0?E=D[D.length-1]:E=null,U!==null&&U.renderEnd()};function Qo(w,W,j,$){if(w.visible===!1)return;if(w.layers.test(W.layers)){if(w.isGroup)j=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(W);else if(w.isLightProbeGrid)T.pushLightProbeGrid(w);else if(w.isLight)T.pushLight(w),w.castShadow&&T.pushShadow(w);else if(w.isSprite){if(!w.frustumCulled||ft.intersectsSprite(w)){$&&qt.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Xt);let Pe=ne.update(w),we=w.material;we.visible&&E.push(w,Pe,we,j,qt.z,null)}}else if((w.isMesh||w.isLine||w.isPoints)&&(!w.frustumCulled||ft.intersectsObject(w))){let Pe=ne.update(w),we=w.material;if($&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),qt.copy(w.boundingSphere.center)):(Pe.boundingSphere===null&&Pe.computeBoundingSphere(),qt.copy(Pe.boundingSphere.center)),qt.applyMatrix4(w.matrixWorld).applyMatrix4(Xt)),Array.isArray(we)){let Ue=Pe.groups;for(let Ce=0,et=Ue.length;Ce<et;Ce++){let rt=Ue[Ce],Ge=we[rt.materialIndex];Ge&&Ge.visible&&E.push(w,Pe,Ge,j,qt.z,rt)}}else we.visible&&E.push(w,Pe,we,j,qt.z,null)}}let Te=w.children;for(let Pe=0,we=Te.length;Pe<we;Pe++)Qo(Te[Pe],W,j,$)}function Ls(w,W,j,$){let{opaque:J,transmissive:Te,transparent:Pe}=w;T.setupLightsView(j),ct===!0&&Oe.setGlobalState(F.clippingPlanes,j),$&&x.viewport(de.copy($)),J.length>0&&ci(J,W,j),Te.length>0&&ci(Te,W,j),Pe.length>0&&ci(Pe,W,j),x.buffers.depth.setTest(!0),x.buffers.depth.setMask(!0),x.buffers.color.setMask(!0),x.setPolygonOffset(!1)}function ea(w,W,j,$){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[$.id]===void 0){let Ge=fe.has("EXT_color_buffer_half_float")||fe.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[$.id]=new Mi(1,1,{generateMipmaps:!0,type:Ge?us:Ti,minFilter:ur,samples:Math.max(4,R.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:_t.workingColorSpace})}let Te=T.state.transmissionRenderTarget[$.id],Pe=$.viewport||de;Te.setSize(Pe.z*F.transmissionResolutionScale,Pe.w*F.transmissionResolutionScale);let we=F.getRenderTarget(),Ue=F.getActiveCubeFace(),Ce=F.getActiveMipmapLevel();F.setRenderTarget(Te),F.getClearColor(st),Qe=F.getClearAlpha(),Qe<1&&F.setClearColor(16777215,.5),F.clear(),Lt&&qe.render(j);let et=F.toneMapping;F.toneMapping=Ki;let rt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),T.setupLightsView($),ct===!0&&Oe.setGlobalState(F.clippingPlanes,$),ci(w,j,$),ee.updateMultisampleRenderTarget(Te),ee.updateRenderTargetMipmap(Te),fe.has("WEBGL_multisampled_render_to_texture")===!1){let Ge=!1;for(let wt=0,rn=W.length;wt<rn;wt++){let en=W[wt],{object:Nt,geometry:bn,material:Ie,group:qn}=en;if(Ie.side===ai&&Nt.layers.test($.layers)){let pt=Ie.side;Ie.side=ti,Ie.needsUpdate=!0,mn(Nt,j,$,bn,Ie,qn),Ie.side=pt,Ie.needsUpdate=!0,Ge=!0}}Ge===!0&&(ee.updateMultisampleRenderTarget(Te),ee.updateRenderTargetMipmap(Te))}F.setRenderTarget(we,Ue,Ce),F.setClearColor(st,Qe),rt!==void 0&&($.viewport=rt),F.toneMapping=et}function ci(w,W,j){let $=W.isScene===!0?W.overrideMaterial:null;for(let J=0,Te=w.length;J<Te;J++){let Pe=w[J],{object:we,geometry:Ue,group:Ce}=Pe,et=Pe.material;et.allowOverride===!0&&$!==null&&(et=$),we.layers.test(j.layers)&&mn(we,W,j,Ue,et,Ce)}}function mn(w,W,j,$,J,Te){w.onBeforeRender(F,W,j,$,J,Te),w.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),J.onBeforeRender(F,W,j,$,w,Te),J.transparent===!0&&J.side===ai&&J.forceSinglePass===!1?(J.side=ti,J.needsUpdate=!0,F.renderBufferDirect(j,W,$,J,w,Te),J.side=$i,J.needsUpdate=!0,F.renderBufferDirect(j,W,$,J,w,Te),J.side=ai):F.renderBufferDirect(j,W,$,J,w,Te),w.onAfterRender(F,W,j,$,J,Te)}function sn(w,W,j){W.isScene!==!0&&(W=vt);let $=K.get(w),J=T.state.lights,Te=T.state.shadowsArray,Pe=J.state.version,we=xe.getParameters(w,J.state,Te,W,j,T.state.lightProbeGridArray),Ue=xe.getProgramCacheKey(we),Ce=$.programs;$.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?W.environment:null,$.fog=W.fog;let et=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;$.envMap=me.get(w.envMap||$.environment,et),$.envMapRotation=$.environment!==null&&w.envMap===null?W.environmentRotation:w.envMapRotation,Ce===void 0&&(w.addEventListener("dispose",Un),Ce=new Map,$.programs=Ce);let rt=Ce.get(Ue);if(rt!==void 0){if($.currentProgram===rt&&$.lightsStateVersion===Pe)return pr(w,we),rt}else we.uniforms=xe.getUniforms(w),U!==null&&w.isNodeMaterial&&U.build(w,j,we),w.onBeforeCompile(we,F),rt=xe.acquireProgram(we,Ue),Ce.set(Ue,rt),$.uniforms=we.uniforms;let Ge=$.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Ge.clippingPlanes=Oe.uniform),pr(w,we),$.needsLights=ta(w),$.lightsStateVersion=Pe,$.needsLights&&(Ge.ambientLightColor.value=J.state.ambient,Ge.lightProbe.value=J.state.probe,Ge.directionalLights.value=J.state.directional,Ge.directionalLightShadows.value=J.state.directionalShadow,Ge.spotLights.value=J.state.spot,Ge.spotLightShadows.value=J.state.spotShadow,Ge.rectAreaLights.value=J.state.rectArea,Ge.ltc_1.value=J.state.rectAreaLTC1,Ge.ltc_2.value=J.state.rectAreaLTC2,Ge.pointLights.value=J.state.point,Ge.pointLightShadows.value=J.state.pointShadow,Ge.hemisphereLights.value=J.state.hemi,Ge.directionalShadowMatrix.value=J.state.directionalShadowMatrix,Ge.spotLightMatrix.value=J.state.spotLightMatrix,Ge.spotLightMap.value=J.state.spotLightMap,Ge.pointShadowMatrix.value=J.state.pointShadowMatrix),$.lightProbeGrid=T.state.lightProbeGridArray.length>0,$.currentProgram=rt,$.uniformsList=null,rt}function fn(w){if(w.uniformsList===null){let W=w.currentProgram.getUniforms();w.uniformsList=$o.seqWithValue(W.seq,w.uniforms)}return w.uniformsList}function pr(w,W){let j=K.get(w);j.outputColorSpace=W.outputColorSpace,j.batching=W.batching,j.batchingColor=W.batchingColor,j.instancing=W.instancing,j.instancingColor=W.instancingColor,j.instancingMorph=W.instancingMorph,j.skinning=W.skinning,j.morphTargets=W.morphTargets,j.morphNormals=W.morphNormals,j.morphColors=W.morphColors,j.morphTargetsCount=W.morphTargetsCount,j.numClippingPlanes=W.numClippingPlanes,j.numIntersection=W.numClipIntersection,j.vertexAlphas=W.vertexAlphas,j.vertexTangents=W.vertexTangents,j.toneMapping=W.toneMapping}function ui(w,W){if(w.length===0)return null;if(w.length===1)return w[0].texture!==null?w[0]:null;b.setFromMatrixPosition(W.matrixWorld);for(let j=0,$=w.length;j<$;j++){let J=w[j];if(J.texture!==null&&J.boundingBox.containsPoint(b))return J}return null}function mr(w,W,j,$,J){W.isScene!==!0&&(W=vt),ee.resetTextureUnits();let Te=W.fog,Pe=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?W.environment:null,we=ie===null?F.outputColorSpace:ie.isXRRenderTarget===!0?ie.texture.colorSpace:_t.workingColorSpace,Ue=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,Ce=me.get($.envMap||Pe,Ue),et=$.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,rt=!!j.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Ge=!!j.morphAttributes.position,wt=!!j.morphAttributes.normal,rn=!!j.morphAttributes.color,en=Ki;$.toneMapped&&(ie===null||ie.isXRRenderTarget===!0)&&(en=F.toneMapping);let Nt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,bn=Nt!==void 0?Nt.length:0,Ie=K.get($),qn=T.state.lights;if(ct===!0&&(ot===!0||w!==le)){let Bt=w===le&&$.id===oe;Oe.setState($,w,Bt)}let pt=!1;$.version===Ie.__version?(Ie.needsLights&&Ie.lightsStateVersion!==qn.state.version||Ie.outputColorSpace!==we||J.isBatchedMesh&&Ie.batching===!1||!J.isBatchedMesh&&Ie.batching===!0||J.isBatchedMesh&&Ie.batchingColor===!0&&J.colorTexture===null||J.isBatchedMesh&&Ie.batchingColor===!1&&J.colorTexture!==null||J.isInstancedMesh&&Ie.instancing===!1||!J.isInstancedMesh&&Ie.instancing===!0||J.isSkinnedMesh&&Ie.skinning===!1||!J.isSkinnedMesh&&Ie.skinning===!0||J.isInstancedMesh&&Ie.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Ie.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Ie.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Ie.instancingMorph===!1&&J.morphTexture!==null||Ie.envMap!==Ce||$.fog===!0&&Ie.fog!==Te||Ie.numClippingPlanes!==void 0&&(Ie.numClippingPlanes!==Oe.numPlanes||Ie.numIntersection!==Oe.numIntersection)||Ie.vertexAlphas!==et||Ie.vertexTangents!==rt||Ie.morphTargets!==Ge||Ie.morphNormals!==wt||Ie.morphColors!==rn||Ie.toneMapping!==en||Ie.morphTargetsCount!==bn||!!Ie.lightProbeGrid!=T.state.lightProbeGridArray.length>0)&&(pt=!0):(pt=!0,Ie.__version=$.version);let Bn=Ie.currentProgram;pt===!0&&(Bn=sn($,W,J),U&&$.isNodeMaterial&&U.onUpdateProgram($,Bn,Ie));let Yn=!1,hi=!1,Ns=!1,Tt=Bn.getUniforms(),on=Ie.uniforms;if(x.useProgram(Bn.program)&&(Yn=!0,hi=!0,Ns=!0),$.id!==oe&&(oe=$.id,hi=!0),Ie.needsLights){let Bt=ui(T.state.lightProbeGridArray,J);Ie.lightProbeGrid!==Bt&&(Ie.lightProbeGrid=Bt,hi=!0)}if(Yn||le!==w){x.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),Tt.setValue(V,"projectionMatrix",w.projectionMatrix),Tt.setValue(V,"viewMatrix",w.matrixWorldInverse);let $n=Tt.map.cameraPosition;$n!==void 0&&$n.setValue(V,Qt.setFromMatrixPosition(w.matrixWorld)),R.logarithmicDepthBuffer&&Tt.setValue(V,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&Tt.setValue(V,"isOrthographic",w.isOrthographicCamera===!0),le!==w&&(le=w,hi=!0,Ns=!0)}if(Ie.needsLights&&(qn.state.directionalShadowMap.length>0&&Tt.setValue(V,"directionalShadowMap",qn.state.directionalShadowMap,ee),qn.state.spotShadowMap.length>0&&Tt.setValue(V,"spotShadowMap",qn.state.spotShadowMap,ee),qn.state.pointShadowMap.length>0&&Tt.setValue(V,"pointShadowMap",qn.state.pointShadowMap,ee)),J.isSkinnedMesh){Tt.setOptional(V,J,"bindMatrix"),Tt.setOptional(V,J,"bindMatrixInverse");let Bt=J.skeleton;Bt&&(Bt.boneTexture===null&&Bt.computeBoneTexture(),Tt.setValue(V,"boneTexture",Bt.boneTexture,ee))}J.isBatchedMesh&&(Tt.setOptional(V,J,"batchingTexture"),Tt.setValue(V,"batchingTexture",J._matricesTexture,ee),Tt.setOptional(V,J,"batchingIdTexture"),Tt.setValue(V,"batchingIdTexture",J._indirectTexture,ee),Tt.setOptional(V,J,"batchingColorTexture"),J._colorsTexture!==null&&Tt.setValue(V,"batchingColorTexture",J._colorsTexture,ee));let ji=j.morphAttributes;if((ji.position!==void 0||ji.normal!==void 0||ji.color!==void 0)&&k.update(J,j,Bn),(hi||Ie.receiveShadow!==J.receiveShadow)&&(Ie.receiveShadow=J.receiveShadow,Tt.setValue(V,"receiveShadow",J.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&W.environment!==null&&(on.envMapIntensity.value=W.environmentIntensity),on.dfgLUT!==void 0&&(on.dfgLUT.value=iA()),hi){if(Tt.setValue(V,"toneMappingExposure",F.toneMappingExposure),Ie.needsLights&&_l(on,Ns),Te&&$.fog===!0&&ke.refreshFogUniforms(on,Te),ke.refreshMaterialUniforms(on,$,he,ae,T.state.transmissionRenderTarget[w.id]),Ie.needsLights&&Ie.lightProbeGrid){let Bt=Ie.lightProbeGrid;on.probesSH.value=Bt.texture,on.probesMin.value.copy(Bt.boundingBox.min),on.probesMax.value.copy(Bt.boundingBox.max),on.probesResolution.value.copy(Bt.resolution)}$o.upload(V,fn(Ie),on,ee)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&($o.upload(V,fn(Ie),on,ee),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&Tt.setValue(V,"center",J.center),Tt.setValue(V,"modelViewMatrix",J.modelViewMatrix),Tt.setValue(V,"normalMatrix",J.normalMatrix),Tt.setValue(V,"modelMatrix",J.matrixWorld),$.uniformsGroups!==void 0){let Bt=$.uniformsGroups;for(let $n=0,Ui=Bt.length;$n<Ui;$n++){let Yr=Bt[$n];ce.update(Yr,Bn),ce.bind(Yr,Bn)}}return Bn}function _l(w,W){w.ambientLightColor.needsUpdate=W,w.lightProbe.needsUpdate=W,w.directionalLights.needsUpdate=W,w.directionalLightShadows.needsUpdate=W,w.pointLights.needsUpdate=W,w.pointLightShadows.needsUpdate=W,w.spotLights.needsUpdate=W,w.spotLightShadows.needsUpdate=W,w.rectAreaLights.needsUpdate=W,w.hemisphereLights.needsUpdate=W}function ta(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return ie},this.setRenderTargetTextures=function(w,W,j){let $=K.get(w);$.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),K.get(w.texture).__webglTexture=W,K.get(w.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:j,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,W){let j=K.get(w);j.__webglFramebuffer=W,j.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(w,W=0,j=0){ie=w,Y=W,H=j;let $=null,J=!1,Te=!1;if(w){let we=K.get(w);if(we.__useDefaultFramebuffer!==void 0){x.bindFramebuffer(V.FRAMEBUFFER,we.__webglFramebuffer),de.copy(w.viewport),ue.copy(w.scissor),_e=w.scissorTest,x.viewport(de),x.scissor(ue),x.setScissorTest(_e),oe=-1;return}else if(we.__webglFramebuffer===void 0)ee.setupRenderTarget(w);else if(we.__hasExternalTextures)ee.rebindTextures(w,K.get(w.texture).__webglTexture,K.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let et=w.depthTexture;if(we.__boundDepthTexture!==et){if(et!==null&&K.has(et)&&(w.width!==et.image.width||w.height!==et.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");ee.setupDepthRenderbuffer(w)}}let Ue=w.texture;(Ue.isData3DTexture||Ue.isDataArrayTexture||Ue.isCompressedArrayTexture)&&(Te=!0);let Ce=K.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Ce[W])?$=Ce[W][j]:$=Ce[W],J=!0):w.samples>0&&ee.useMultisampledRTT(w)===!1?$=K.get(w).__webglMultisampledFramebuffer:Array.isArray(Ce)?$=Ce[j]:$=Ce,de.copy(w.viewport),ue.copy(w.scissor),_e=w.scissorTest}else de.copy(Be).multiplyScalar(he).floor(),ue.copy(St).multiplyScalar(he).floor(),_e=$e;if(j!==0&&($=G),x.bindFramebuffer(V.FRAMEBUFFER,$)&&x.drawBuffers(w,$),x.viewport(de),x.scissor(ue),x.setScissorTest(_e),J){let we=K.get(w.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_CUBE_MAP_POSITIVE_X+W,we.__webglTexture,j)}else if(Te){let we=W;for(let Ue=0;Ue<w.textures.length;Ue++){let Ce=K.get(w.textures[Ue]);V.framebufferTextureLayer(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0+Ue,Ce.__webglTexture,j,we)}}else if(w!==null&&j!==0){let we=K.get(w.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,we.__webglTexture,j)}oe=-1},this.readRenderTargetPixels=function(w,W,j,$,J,Te,Pe,we=0){if(!(w&&w.isWebGLRenderTarget)){Je("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ue=K.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ue=Ue[Pe]),Ue){x.bindFramebuffer(V.FRAMEBUFFER,Ue);try{let Ce=w.textures[we],et=Ce.format,rt=Ce.type;if(w.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+we),!R.textureFormatReadable(et)){Je("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!R.textureTypeReadable(rt)){Je("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=w.width-$&&j>=0&&j<=w.height-J&&V.readPixels(W,j,$,J,Se.convert(et),Se.convert(rt),Te)}finally{let Ce=ie!==null?K.get(ie).__webglFramebuffer:null;x.bindFramebuffer(V.FRAMEBUFFER,Ce)}}},this.readRenderTargetPixelsAsync=async function(w,W,j,$,J,Te,Pe,we=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ue=K.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ue=Ue[Pe]),Ue)if(W>=0&&W<=w.width-$&&j>=0&&j<=w.height-J){x.bindFramebuffer(V.FRAMEBUFFER,Ue);let Ce=w.textures[we],et=Ce.format,rt=Ce.type;if(w.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+we),!R.textureFormatReadable(et))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!R.textureTypeReadable(rt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Ge=V.createBuffer();V.bindBuffer(V.PIXEL_PACK_BUFFER,Ge),V.bufferData(V.PIXEL_PACK_BUFFER,Te.byteLength,V.STREAM_READ),V.readPixels(W,j,$,J,Se.convert(et),Se.convert(rt),0);let wt=ie!==null?K.get(ie).__webglFramebuffer:null;x.bindFramebuffer(V.FRAMEBUFFER,wt);let rn=V.fenceSync(V.SYNC_GPU_COMMANDS_COMPLETE,0);return V.flush(),await H_(V,rn,4),V.bindBuffer(V.PIXEL_PACK_BUFFER,Ge),V.getBufferSubData(V.PIXEL_PACK_BUFFER,0,Te),V.deleteBuffer(Ge),V.deleteSync(rn),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,W=null,j=0){let $=Math.pow(2,-j),J=Math.floor(w.image.width*$),Te=Math.floor(w.image.height*$),Pe=W!==null?W.x:0,we=W!==null?W.y:0;ee.setTexture2D(w,0),V.copyTexSubImage2D(V.TEXTURE_2D,j,0,0,Pe,we,J,Te),x.unbindTexture()},this.copyTextureToTexture=function(w,W,j=null,$=null,J=0,Te=0){let Pe,we,Ue,Ce,et,rt,Ge,wt,rn,en=w.isCompressedTexture?w.mipmaps[Te]:w.image;if(j!==null)Pe=j.max.x-j.min.x,we=j.max.y-j.min.y,Ue=j.isBox3?j.max.z-j.min.z:1,Ce=j.min.x,et=j.min.y,rt=j.isBox3?j.min.z:0;else{let on=Math.pow(2,-J);Pe=Math.floor(en.width*on),we=Math.floor(en.height*on),w.isDataArrayTexture?Ue=en.depth:w.isData3DTexture?Ue=Math.floor(en.depth*on):Ue=1,Ce=0,et=0,rt=0}$!==null?(Ge=$.x,wt=$.y,rn=$.z):(Ge=0,wt=0,rn=0);let Nt=Se.convert(W.format),bn=Se.convert(W.type),Ie;W.isData3DTexture?(ee.setTexture3D(W,0),Ie=V.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?(ee.setTexture2DArray(W,0),Ie=V.TEXTURE_2D_ARRAY):(ee.setTexture2D(W,0),Ie=V.TEXTURE_2D),x.activeTexture(V.TEXTURE0),x.pixelStorei(V.UNPACK_FLIP_Y_WEBGL,W.flipY),x.pixelStorei(V.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),x.pixelStorei(V.UNPACK_ALIGNMENT,W.unpackAlignment);let qn=x.getParameter(V.UNPACK_ROW_LENGTH),pt=x.getParameter(V.UNPACK_IMAGE_HEIGHT),Bn=x.getParameter(V.UNPACK_SKIP_PIXELS),Yn=x.getParameter(V.UNPACK_SKIP_ROWS),hi=x.getParameter(V.UNPACK_SKIP_IMAGES);x.pixelStorei(V.UNPACK_ROW_LENGTH,en.width),x.pixelStorei(V.UNPACK_IMAGE_HEIGHT,en.height),x.pixelStorei(V.UNPACK_SKIP_PIXELS,Ce),x.pixelStorei(V.UNPACK_SKIP_ROWS,et),x.pixelStorei(V.UNPACK_SKIP_IMAGES,rt);let Ns=w.isDataArrayTexture||w.isData3DTexture,Tt=W.isDataArrayTexture||W.isData3DTexture;if(w.isDepthTexture){let on=K.get(w),ji=K.get(W),Bt=K.get(on.__renderTarget),$n=K.get(ji.__renderTarget);x.bindFramebuffer(V.READ_FRAMEBUFFER,Bt.__webglFramebuffer),x.bindFramebuffer(V.DRAW_FRAMEBUFFER,$n.__webglFramebuffer);for(let Ui=0;Ui<Ue;Ui++)Ns&&(V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,K.get(w).__webglTexture,J,rt+Ui),V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,K.get(W).__webglTexture,Te,rn+Ui)),V.blitFramebuffer(Ce,et,Pe,we,Ge,wt,Pe,we,V.DEPTH_BUFFER_BIT,V.NEAREST);x.bindFramebuffer(V.READ_FRAMEBUFFER,null),x.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else if(J!==0||w.isRenderTargetTexture||K.has(w)){let on=K.get(w),ji=K.get(W);x.bindFramebuffer(V.READ_FRAMEBUFFER,q),x.bindFramebuffer(V.DRAW_FRAMEBUFFER,O);for(let Bt=0;Bt<Ue;Bt++)Ns?V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,on.__webglTexture,J,rt+Bt):V.framebufferTexture2D(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,on.__webglTexture,J),Tt?V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,ji.__webglTexture,Te,rn+Bt):V.framebufferTexture2D(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,ji.__webglTexture,Te),J!==0?V.blitFramebuffer(Ce,et,Pe,we,Ge,wt,Pe,we,V.COLOR_BUFFER_BIT,V.NEAREST):Tt?V.copyTexSubImage3D(Ie,Te,Ge,wt,rn+Bt,Ce,et,Pe,we):V.copyTexSubImage2D(Ie,Te,Ge,wt,Ce,et,Pe,we);x.bindFramebuffer(V.READ_FRAMEBUFFER,null),x.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else Tt?w.isDataTexture||w.isData3DTexture?V.texSubImage3D(Ie,Te,Ge,wt,rn,Pe,we,Ue,Nt,bn,en.data):W.isCompressedArrayTexture?V.compressedTexSubImage3D(Ie,Te,Ge,wt,rn,Pe,we,Ue,Nt,en.data):V.texSubImage3D(Ie,Te,Ge,wt,rn,Pe,we,Ue,Nt,bn,en):w.isDataTexture?V.texSubImage2D(V.TEXTURE_2D,Te,Ge,wt,Pe,we,Nt,bn,en.data):w.isCompressedTexture?V.compressedTexSubImage2D(V.TEXTURE_2D,Te,Ge,wt,en.width,en.height,Nt,en.data):V.texSubImage2D(V.TEXTURE_2D,Te,Ge,wt,Pe,we,Nt,bn,en);x.pixelStorei(V.UNPACK_ROW_LENGTH,qn),x.pixelStorei(V.UNPACK_IMAGE_HEIGHT,pt),x.pixelStorei(V.UNPACK_SKIP_PIXELS,Bn),x.pixelStorei(V.UNPACK_SKIP_ROWS,Yn),x.pixelStorei(V.UNPACK_SKIP_IMAGES,hi),Te===0&&W.generateMipmaps&&V.generateMipmap(Ie),x.unbindTexture()},this.initRenderTarget=function(w){K.get(w).__webglFramebuffer===void 0&&ee.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?ee.setTextureCube(w,0):w.isData3DTexture?ee.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?ee.setTexture2DArray(w,0):ee.setTexture2D(w,0),x.unbindTexture()},this.resetState=function(){Y=0,H=0,ie=null,x.reset(),Ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Yi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=_t._getDrawingBufferColorSpace(e),t.unpackColorSpace=_t._getUnpackColorSpace()}};var hh=class{constructor(e){this.chain=e;let t=e.segments,i=Math.min(4,Math.max(1,Math.round(3600/Math.max(1,t)))),s=[];for(let r=0;r<t;){let o=r;for(;o+1<t&&e.diameter_m[o+1]===e.diameter_m[r]&&e.part[o+1]===e.part[r];)o++;let a=s.length,l=(o-r+1)*i;for(let c=0;c<=l;c++)s.push(r-.5+c/i);this.stretches.push({first:a,last:s.length-1,part:e.part[r]??0}),r=o+1}this.coordinate=Float32Array.from(s),this.rows=Math.max(1,Math.ceil(s.length/512)),this.texels=new Float32Array(this.rows*512*3*4),this.radius=new Float32Array(s.length);for(let{first:r,last:o}of this.stretches){let a=Math.min(t-1,Math.round(s[r]+.5));this.radius.fill(.5*(e.diameter_m[a]??.05),r,o+1)}this.arc=this.arcs()}chain;coordinate;arc;radius;stretches=[];texels;rows;get count(){return this.coordinate.length}arcs(){let e=new Float64Array(this.chain.segments+1);return this.chain.length_m.forEach((t,i)=>e[i+1]=e[i]+t),this.coordinate.map(t=>{let i=Math.min(this.chain.segments-1,Math.floor(t+.5));return e[i]+(t+.5-i)*(this.chain.length_m[i]??0)})}update(e,t){let{texels:i,coordinate:s}=this,r=this.chain.segments-1;for(let o=0;o<this.count;o++){let a=s[o],l=Math.min(Math.max(0,r-1),Math.max(0,Math.floor(a))),c=Math.min(r,l+1),u=Math.max(0,l-1),d=Math.min(r,c+1),h=a-l,f=12*o;for(let v=0;v<3;v++){let g=e[3*l+v],p=e[3*c+v];if(h<0||h>1){i[f+v]=g+h*(p-g);continue}let S=u<l?.5*(p-e[3*u+v]):p-g,C=d>c?.5*(e[3*d+v]-g):p-g,b=p-g;i[f+v]=g+h*(S+h*(3*b-2*S-C+h*(S+C-2*b)))}let m=Math.min(1,Math.max(0,h));i[f+3]=t[l]+m*(t[c]-t[l]),i[f+7]=this.radius[o],i[f+11]=this.arc[o]}for(let o of this.stretches)this.frame(o)}frame({first:e,last:t}){let i=this.texels,s=12,r=1,o=0,a=0,l=0,c=0,u=0;for(let d=e;d<=t;d++){let h=s*Math.max(e,d-1),f=s*Math.min(t,d+1),m=i[f]-i[h],v=i[f+1]-i[h+1],g=i[f+2]-i[h+2],p=Math.sqrt(m*m+v*v+g*g);p>1e-6&&(r=m/p,o=v/p,a=g/p);let S=l*r+c*o+u*a;l-=S*r,c-=S*o,u-=S*a;let C=Math.sqrt(l*l+c*c+u*u);if(C<.1){let E=Math.abs(a)>.9;S=E?r:a,l=(E?1:0)-S*r,c=-S*o,u=(E?0:1)-S*a,C=Math.sqrt(l*l+c*c+u*u)}l/=C,c/=C,u/=C;let b=s*d;i[b+4]=l,i[b+5]=c,i[b+6]=u,i[b+8]=r,i[b+9]=o,i[b+10]=a}}};var Sx=()=>({factor:{value:1},pixel:{value:.001},reel:{value:new jt(0,0,0,0)},reelAxis:{value:new z(0,1,0)},light:{value:new je(.62,.42)}}),Ko=`
uniform float factor;
uniform vec4 reel;
uniform vec3 reelAxis;
float spreadBy(vec3 place) {
  if (reel.w <= 0.0) return factor;
  vec3 r = place - reel.xyz;
  r -= dot(r, reelAxis) * reelAxis;
  return mix(1.0, factor, smoothstep(1.1, 2.5, length(r) / reel.w));
}
`,Jo=`
uniform vec2 light;
vec3 lit(vec3 colour, vec3 normal, vec3 eye, float gloss) {
  vec3 lamp = normalize(vec3(-0.45, 0.75, 0.6));
  float sky = 0.5 + 0.5 * dot(normal, normalize((viewMatrix * vec4(0.0, 0.0, 1.0, 0.0)).xyz));
  float key = max(dot(normal, lamp), 0.0);
  float shine = pow(max(dot(normal, normalize(lamp + eye)), 0.0), 40.0);
  return colour * (light.x * (0.72 + 0.28 * sky) + light.y * key) + gloss * shine;
}
`;var Fi=12,sA=`
${Ko}
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
`,rA=`
${Jo}
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
`;function oA({first:n,last:e},t,i,s){let r=i.length,o=(a,l,c,u)=>{let d=2*Math.PI*l/Fi;t.push(a,Math.cos(d),Math.sin(d),c),i.push(u)};for(let a=n;a<=e;a++)for(let l=0;l<Fi;l++)o(a,l,0,1);for(let a=0;a<e-n;a++)for(let l=0;l<Fi;l++){let c=r+a*Fi+l,u=r+a*Fi+(l+1)%Fi;s.push(c,u,c+Fi,u,u+Fi,c+Fi)}for(let a of[-1,1]){let l=a<0?n:e,c=i.length;o(l,0,a,0);for(let u=0;u<Fi;u++)o(l,u,a,1);for(let u=0;u<Fi;u++){let d=c+1+u,h=c+1+(u+1)%Fi;s.push(c,...a<0?[h,d]:[d,h])}}}var dh=class{mesh;rings;texture;constructor(e,t){this.rings=new hh(e);let{texels:i,rows:s}=this.rings;this.texture=new Vr(i,512*3,s,ni,Ei),this.texture.magFilter=this.texture.minFilter=vn;let r=new Vr(U0(256),256,1,ni);r.magFilter=r.minFilter=En,r.needsUpdate=!0;let o=[],a=[],l=[];for(let d of this.rings.stretches)oA(d,o,a,l);let c=new yn;c.setAttribute("corner",new It(o,4)),c.setAttribute("rim",new It(a,1)),c.setIndex(l);let u=new an({uniforms:{...t,rings:{value:this.texture},colours:{value:r},scale:{value:new je(0,1)},thinnest:{value:2},mark:{value:1},plain:{value:1}},vertexShader:sA,fragmentShader:rA,side:$i});this.mesh=new Ot(c,u),this.mesh.frustumCulled=!1}update(e,t){this.rings.update(e,t),this.texture.needsUpdate=!0}scale(e){let t=this.mesh.material.uniforms;t.plain.value=e?0:1,e&&t.scale.value.set(e.low,e.high)}marks(e){this.mesh.material.uniforms.mark.value=e}centre(e){let t=12*e,i=this.rings.texels;return new z(i[t],i[t+1],i[t+2])}dispose(){this.texture.dispose(),this.mesh.material.uniforms.colours.value.dispose(),this.mesh.material.dispose(),this.mesh.geometry.dispose()}};var aA=`
${Ko}
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
`,lA=`
${Jo}
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
`;function fs(n){let{r:e,g:t,b:i}=new xt(n).convertLinearToSRGB();return new z(e,t,i)}function wx(n,e){let t=(e.opacity??1)<1;return new an({uniforms:{...n,colour:{value:fs(e.colour)},opacity:{value:e.opacity??1}},vertexShader:aA,fragmentShader:lA,defines:e.smooth?{SMOOTH:""}:{},transparent:t,depthWrite:!t,depthTest:!e.onTop,side:ai})}function fh(n,e,t,i=0){let s=new Hn().setFromUnitVectors(new z(0,1,0),new z(...dn(t,[0,1,0])));return n.translate(0,i,0),n.applyMatrix4(new Vt().makeRotationFromQuaternion(s)),n.translate(...e)}function Tx(n,e,t){let i=e.at(n.center_m),{radius_m:s,width_m:r}=n,o=n.barrel_radius_m??.6*s,a=fh(new Rs(.985*o,.985*o,r,48),i,n.axis),l=[new Ot(a,t("drum"))];for(let c of[-.5,.5]){let u=new Rs(s,s,.02*s,64),d=new Ot(fh(u,i,n.axis,c*(r+.02*s)),t("drum",{opacity:.3}));d.renderOrder=1,l.push(d)}return l}function Ex(n,e,t){let[i,s,r]=e.at(n.position_m),o=dn([n.direction[0],n.direction[1],0],[1,0,0]),a=[-o[1],o[0],0],l=new Hn().setFromUnitVectors(new z(0,1,0),new z(...a)),c=new Cs(1.1,.9,.5).applyMatrix4(new Vt().makeRotationFromQuaternion(l));c.translate(i+.45*o[0],s+.45*o[1],r-.65);let u=fh(new Rs(.25,.25,.6,32),[i+.3*o[0],s+.3*o[1],r-.25],a);return[new Ot(c,t("frame")),new Ot(u,t("drum"))]}function Ax({obstacles:n,rollers:e},t,i){return(n??[]).flatMap(s=>{let r=e[s.roller];if(!r)return[];let o=t.at(r.position_m),a=dn(r.axis);if(s.ring_m!==null){let d=new Ka(s.ring_m,s.edge_m??.1,32,64);return[new Ot(fh(d.rotateX(.5*Math.PI),o,a),i("obstacle",{opacity:.2}))]}let l=dn(s.side,[0,1,0]),c=new Vt().makeBasis(new z(...a),new z(...l),new z(...rs(a,l))),u=new Cs(...s.size_m).applyMatrix4(c).translate(...o);return[new Ot(u,i("obstacle"))]})}function cA(n,e){let t=[0,1,0];return n.map((i,s)=>{let r=dn(Ft(n[Math.min(n.length-1,s+1)],n[Math.max(0,s-1)])),o=rs(e[s],r);return t=xi(o)>.05?dn(o):dn(Ut(t,r,-Ii(t,r)),t),{left:t,above:rs(r,t)}})}function Cx({line:n,base:e,profile:t,closed:i,ups:s,widen:r=0}){let o=[],a=[],l=[],c=[],u=[],d=cA(n,s),h=t.length;n.forEach((m,v)=>{let{left:g,above:p}=d[v],S=Ii(Ft(m,e[v]),p),C=Ut(m,p,-S);for(let{across:b,above:E,wide:T=0}of t)o.push(...C),a.push(...Ut(Ut([0,0,0],g,b),p,S+E)),l.push(...Ut([0,0,0],g,T)),c.push(...dn(Ut(Ut([0,0,0],g,b),p,E),p));if(v!==0)for(let b=0;b<(i?h:h-1);b++){let E=(v-1)*h+b,T=(v-1)*h+(b+1)%h;u.push(E,T,E+h,T,T+h,E+h)}});let f=new yn;return f.setAttribute("position",new It(o,3)),f.setAttribute("offset",new It(a,3)),f.setAttribute("side",new It(l,3)),f.setAttribute("normal",new It(c,3)),f.setAttribute("widen",new It(new Float32Array(o.length/3).fill(r),1)),f.setIndex(u),f}var Rx=(n,e)=>Array.from({length:e},(t,i)=>{let s=2*Math.PI*i/e;return{across:n*Math.cos(s),above:n*Math.sin(s)}}),Px=(n,e,t,i)=>[{across:n,above:t},{across:n+e,above:t},{across:n+e,above:i},{across:n,above:i}];function Ix(n,e,t){let i={line:n.slice(0,1),ups:e.slice(0,1)};for(let s=1;s<n.length;s++){let[r,o]=[n[s-1],n[s]],a=Math.min(400,Math.max(1,Math.ceil(xi(Ft(o,r))/t)));for(let l=1;l<=a;l++)i.line.push(Ut(r,Ft(o,r),l/a)),i.ups.push(Ut(e[s-1],Ft(e[s],e[s-1]),l/a))}return i}var uA=28,Lx=1,hA=1.8,Nx=.6,ph={width:.1,height:.22},mh=class{constructor(e,t,i){this.model=e;this.shared=t;let s=e.run.geometry;if(!s)return;this.route(i);for(let a of s.surfaces)this.surface(a);for(let a of s.conveyors)this.conveyor(a);let r=(a,l={})=>this.paint(a,l),o=[...s.reel?Tx(s.reel,e,r):[],...s.winch?Ex(s.winch,e,r):[],...Ax(s,e,r)];for(let a of o)this.group.add(a)}model;shared;group=new Ts;cast=null;painted=[];paint(e,t){let i=wx(this.shared,{colour:"#888888",...t});return this.painted.push({material:i,part:e}),i}route(e){let t=this.model.path?.points??[],i=(s,r,o)=>{let a=new yn;a.setAttribute("position",new It(s.flat(),3));let l=new Vo({transparent:!0,opacity:o});this.painted.push({material:l,part:r});let c=new zo(a,l);return this.group.add(c),c};i(t,"route",.7),this.cast=i(t.map(([s,r])=>[s,r,e]),"grid",.4)}swept(e,t,i,s,r=0){let{line:o,ups:a}=Ix(e,s?.length===e.length?s:e.map(()=>[0,0,1]),Lx),l=this.model.path,c=o.map(u=>{let d=l?.nearest(u);return l&&d&&d.distance<3?l.at(d.s):u});return Cx({line:o,base:c,profile:t,closed:i,ups:a,widen:r})}surface(e){let t=e.points_m.map(this.model.at);if(t.length<2)return;let i=e.kind==="duct"&&e.diameter_m,s=i?this.swept(t,Rx(.5*i,uA),!0,e.up):this.swept(t,dA(e),!1,e.up??t.map(()=>e.normal??[0,0,1]),this.widening(e)),r=i?this.paint("duct",{opacity:.13,smooth:!0}):this.paint("floor",{opacity:.55}),o=new Ot(s,r);o.renderOrder=i?2:1,this.group.add(o)}widening(e){return hA*this.model.diameter/(e.width_m??Nx)}conveyor(e){let{path:t,at:i}=this.model,{from_m:s,to_m:r}=e,o=Math.max(2,Math.ceil((r-s)/Lx)+1),a=t?Array.from({length:o},(c,u)=>t.at(s+(r-s)*u/(o-1))):e.points_m.map(i);if(a.length<2)return;let l=.5*this.model.diameter;for(let c of[l,-l-ph.width]){let u=Px(c,ph.width,-.5*ph.height,.5*ph.height);this.group.add(new Ot(this.swept(a,u,!0),this.paint("belt",{})))}}shadow(e){this.cast&&(this.cast.visible=e)}recolour(e){for(let{material:t,part:i}of this.painted)t instanceof an?t.uniforms.colour.value=fs(e[i]):t.color.set(e[i])}dispose(){this.group.traverse(e=>{(e instanceof Ot||e instanceof zo)&&e.geometry.dispose()});for(let{material:e}of this.painted)e.dispose()}};function dA({width_m:n,height_m:e,section:t}){let i=.5*(n??Nx),s=e??0;return t==="v"?[-i,0,i].map(r=>({across:r,above:s*Math.abs(r)/i})):s>0?[{across:-i,above:s},{across:-i,above:0},{across:i,above:0},{across:i,above:s}]:[i,-i].map(r=>({across:0,above:0,wide:r}))}function tp(n){let e=n.reduce((i,s)=>Math.min(i,s[2]),1/0),t=i=>{let s=n.map(r=>r[i]);return s.reduce((r,o)=>Math.max(r,o),-1/0)-s.reduce((r,o)=>Math.min(r,o),1/0)};return Number.isFinite(e)?e-Math.max(1,.008*Math.hypot(t(0),t(1))):-1}var fA=`
varying vec2 place;
void main() {
  place = position.xy;
  gl_Position = projectionMatrix * viewMatrix * modelMatrix * vec4(position, 1.0);
}
`,pA=`
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
`,gh=class{mesh;spacing=1;constructor(e,t){let i=new an({uniforms:{colour:{value:fs("#888")},spacing:{value:1},focus:{value:new z(0,0,t)}},vertexShader:fA,fragmentShader:pA,transparent:!0,depthWrite:!1,side:ai});this.mesh=new Ot(new zr(2*t,2*t),i),this.mesh.position.z=e,this.mesh.renderOrder=-1}follow(e,t,i,s){let r=i/14/s,o=10**Math.floor(Math.log10(r));this.spacing=s*o*(r/o>5?10:r/o>2?5:2);let a=this.mesh.material.uniforms;a.spacing.value=this.spacing,a.focus.value.set(e,t,1.6*i)}recolour(e){this.mesh.material.uniforms.colour.value=fs(e)}dispose(){this.mesh.geometry.dispose(),this.mesh.material.dispose()}};var Xr=n=>({x:new Float32Array(n),y:new Float32Array(n),depth:new Float32Array(n)});function jo(n,e,t,i,s){let r=c=>[e[c],e[c+4],e[c+8],e[c+12]],[o,a,l]=[r(0),r(1),r(3)];for(let c=0;c<s.x.length;c++){let u=n[3*c],d=n[3*c+1],h=n[3*c+2],f=l[0]*u+l[1]*d+l[2]*h+l[3];s.depth[c]=f,s.x[c]=(.5+.5*(o[0]*u+o[1]*d+o[2]*h+o[3])/f)*t,s.y[c]=(.5-.5*(a[0]*u+a[1]*d+a[2]*h+a[3])/f)*i}}function Dx(n,e,t,i){let s=-1,r=1/0;for(let o=0;o<n.x.length;o++){let a=n.depth[o];if(a<=0)continue;let c=Math.hypot(n.x[o]-e,n.y[o]-t)/i(a);c<1&&c*(.2+a)<r&&(r=c*(.2+a),s=o)}return s}function Fx(n,e,t,i){let s=null;for(let r=0;r+1<n.x.length;r++){if(n.depth[r]<=0||n.depth[r+1]<=0)continue;let o=n.x[r+1]-n.x[r],a=n.y[r+1]-n.y[r],l=o*o+a*a,c=l>0?((e-n.x[r])*o+(t-n.y[r])*a)/l:0,u=Math.min(1,Math.max(0,c)),d=Math.hypot(n.x[r]+u*o-e,n.y[r]+u*a-t);d<=i&&(!s||d<s.pixels)&&(s={index:r+u,pixels:d})}return s}function mA(n){let e=n.map((s,r)=>r).sort((s,r)=>n[r].weight-n[s].weight),t=[],i=new Array(n.length).fill(!1);for(let s of e){let r=n[s];!t.every(a=>Math.abs(r.x-a.x)*2>=r.width+a.width||Math.abs(r.y-a.y)*2>=r.height+a.height)&&r.weight<100||(i[s]=!0,t.push(r))}return i}var Ux=6.6,gA=20,Ox=16,_h=class{root=I("div",{class:"view-labels","aria-hidden":"true"});elements=new Map;screen=Xr(0);points=new Float32Array(0);set(e,t){let i=this.elements.get(e);if(!t){i?.element.remove(),this.elements.delete(e);return}if(i&&i.label.text===t.text&&i.label.kind===t.kind){i.label=t;return}let s=i?.element??I("span");s.className=`view-label view-label-${t.kind}`,s.replaceChildren(I("b",{},t.text),I("i")),i||this.root.append(s),this.elements.set(e,{element:s,label:t})}update(e,t,i){let s=[...this.elements.values()];this.screen.x.length!==s.length&&(this.screen=Xr(s.length),this.points=new Float32Array(3*s.length)),s.forEach(({label:u},d)=>this.points.set(u.point,3*d)),jo(this.points,e.elements,t,i,this.screen);let{x:r,y:o,depth:a}=this.screen,l=s.map((u,d)=>a[d]>0&&r[d]>0&&r[d]<t&&o[d]>Ox&&o[d]<i),c=mA(s.map(({label:u},d)=>({x:l[d]?r[d]:-1e6*(d+1),y:l[d]?o[d]-Ox:0,width:Ux*u.text.length+14,height:gA,weight:u.weight})));s.forEach(({element:u},d)=>{let h=l[d]&&c[d];if(u.hidden=!h,!h)return;let f=.5*(Ux*s[d].label.text.length+14),m=Math.min(Math.max(r[d],f),t-f);u.style.setProperty("--aside",`${(m-r[d]).toFixed(0)}px`),u.style.transform=`translate(${r[d].toFixed(1)}px, ${o[d].toFixed(1)}px)`})}};var Bx={light:{ground:"#f4f6f8",grid:"#9aa7b4",route:"#5c6b7a",duct:"#4a78a8",floor:"#b9b1a2",belt:"#3f5f68",steel:"#b3bdc7",drum:"#b98d5e",frame:"#59636e",obstacle:"#b0532f"},dark:{ground:"#12171d",grid:"#465362",route:"#8796a6",duct:"#7fb0e6",floor:"#5b574f",belt:"#6f97a2",steel:"#6b7783",drum:"#a87f54",frame:"#98a4b0",obstacle:"#d9774f"}};var _A=.1,xA=.4,vA=2,yA=2.2,bA=.42,MA=`
${Ko}
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
`,SA=`
${Jo}
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
`,kx=({kind:n})=>n!=="box"&&n!=="bell-mouth";function wA(n,e,t){let i=n?.nearest(e);if(!n||!i||i.distance>vA||i.distance<1e-6)return{base:e,away:[0,0,-1],gap:-t};let s=n.at(i.s);return{base:s,away:dn(Ft(e,s)),gap:i.distance-t}}var xh=class{mesh;centres;stand;constructor(e,{at:t,path:i,diameter:s},r){let o=TA(e);this.stand=e.map(d=>{let h=kx(d)?d.radius_m??_A:0;return{...wA(i,t(d.position_m),h),radius:h,largest:h>0?bA*o:0}}),this.centres=new Float32Array(3*e.length);let a=new Rs(1,1,1,20),l=new el;l.index=a.index,l.setAttribute("position",a.getAttribute("position")),l.setAttribute("normal",a.getAttribute("normal"));let c=(d,h,f)=>{let m=new Float32Array(h*e.length);e.forEach((v,g)=>m.set(f(v,g),h*g)),l.setAttribute(d,new qa(m,h))};c("base",3,(d,h)=>this.stand[h].base),c("away",4,(d,h)=>[...this.stand[h].away,this.stand[h].gap]),c("axis",3,d=>dn(d.axis,[0,1,0])),c("measure",4,(d,h)=>[this.stand[h].radius,kx(d)?d.width_m??xA:0,this.stand[h].largest,h]),l.instanceCount=e.length;let u=new an({uniforms:{...r,widest:{value:yA*s},colour:{value:fs("#8d99a6")},pickedColour:{value:fs("#e8590c")},picked:{value:-1},hovered:{value:-1}},vertexShader:MA,fragmentShader:SA});this.mesh=new Ot(l,u),this.mesh.frustumCulled=!1,this.place(1)}place(e){this.stand.forEach(({base:t,away:i,gap:s,radius:r,largest:o},a)=>{let l=Math.max(r,Math.min(e*r,o));this.centres.set(Ut(t,i,e*s+l),3*a)})}centre(e){return[this.centres[3*e],this.centres[3*e+1],this.centres[3*e+2]]}drawnRadius(e,t){let{radius:i,largest:s}=this.stand[e];return Math.max(i,Math.min(t*i,s))}mark(e,t){this.mesh.material.uniforms.picked.value=e,this.mesh.material.uniforms.hovered.value=t}recolour(e){this.mesh.material.uniforms.colour.value=fs(e)}dispose(){this.mesh.geometry.dispose(),this.mesh.material.dispose()}};function TA(n){let e=n.map(s=>s.s_m).filter(s=>s!==null);e.sort((s,r)=>s-r);let i=e.slice(1).map((s,r)=>s-e[r]).filter(s=>s>.001).sort((s,r)=>s-r);return i[Math.floor(i.length/2)]??1/0}var Vx={type:"change"},ip={type:"start"},Gx={type:"end"},vh=new kr,zx=new Di,EA=Math.cos(70*Nf.DEG2RAD),Rn=new z,li=2*Math.PI,zt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},np=1e-6,yh=class extends tl{constructor(e,t=null){super(e,t),this.state=zt.NONE,this.target=new z,this.cursor=new z,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:ar.ROTATE,MIDDLE:ar.DOLLY,RIGHT:ar.PAN},this.touches={ONE:lr.ROTATE,TWO:lr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new z,this._lastQuaternion=new Hn,this._lastTargetPosition=new z,this._quat=new Hn().setFromUnitVectors(e.up,new z(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Go,this._sphericalDelta=new Go,this._scale=1,this._panOffset=new z,this._rotateStart=new je,this._rotateEnd=new je,this._rotateDelta=new je,this._panStart=new je,this._panEnd=new je,this._panDelta=new je,this._dollyStart=new je,this._dollyEnd=new je,this._dollyDelta=new je,this._dollyDirection=new z,this._mouse=new je,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=CA.bind(this),this._onPointerDown=AA.bind(this),this._onPointerUp=RA.bind(this),this._onContextMenu=UA.bind(this),this._onMouseWheel=LA.bind(this),this._onKeyDown=NA.bind(this),this._onTouchStart=DA.bind(this),this._onTouchMove=FA.bind(this),this._onMouseDown=PA.bind(this),this._onMouseMove=IA.bind(this),this._interceptControlDown=OA.bind(this),this._interceptControlUp=BA.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction=""}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Vx),this.update(),this.state=zt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Rn.copy(t).sub(this.target),Rn.applyQuaternion(this._quat),this._spherical.setFromVector3(Rn),this.autoRotate&&this.state===zt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=li:i>Math.PI&&(i-=li),s<-Math.PI?s+=li:s>Math.PI&&(s-=li),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Rn.setFromSpherical(this._spherical),Rn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Rn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Rn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new z(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new z(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Rn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(vh.origin.copy(this.object.position),vh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(vh.direction))<EA?this.object.lookAt(this.target):(zx.setFromNormalAndCoplanarPoint(this.object.up,this.target),vh.intersectPlane(zx,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>np||8*(1-this._lastQuaternion.dot(this.object.quaternion))>np||this._lastTargetPosition.distanceToSquared(this.target)>np?(this.dispatchEvent(Vx),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?li/60*this.autoRotateSpeed*e:li/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Rn.setFromMatrixColumn(t,0),Rn.multiplyScalar(-e),this._panOffset.add(Rn)}_panUp(e,t){this.screenSpacePanning===!0?Rn.setFromMatrixColumn(t,1):(Rn.setFromMatrixColumn(t,0),Rn.crossVectors(this.object.up,Rn)),Rn.multiplyScalar(e),this._panOffset.add(Rn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Rn.copy(s).sub(this.target);let r=Rn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientX),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(li*this._rotateDelta.x/t.clientHeight),this._rotateUp(li*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(li*this._rotateDelta.x/t.clientHeight),this._rotateUp(li*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new je,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function AA(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function CA(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function RA(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Gx),this.state=zt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function PA(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case ar.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=zt.DOLLY;break;case ar.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=zt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=zt.ROTATE}break;case ar.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=zt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=zt.PAN}break;default:this.state=zt.NONE}this.state!==zt.NONE&&this.dispatchEvent(ip)}function IA(n){switch(this.state){case zt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case zt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case zt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function LA(n){this.enabled===!1||this.enableZoom===!1||this.state!==zt.NONE||(n.preventDefault(),this.dispatchEvent(ip),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Gx))}function NA(n){this.enabled!==!1&&this._handleKeyDown(n)}function DA(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case lr.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(n),this.state=zt.TOUCH_ROTATE;break;case lr.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(n),this.state=zt.TOUCH_PAN;break;default:this.state=zt.NONE}break;case 2:switch(this.touches.TWO){case lr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=zt.TOUCH_DOLLY_PAN;break;case lr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=zt.TOUCH_DOLLY_ROTATE;break;default:this.state=zt.NONE}break;default:this.state=zt.NONE}this.state!==zt.NONE&&this.dispatchEvent(ip)}function FA(n){switch(this._trackPointer(n),this.state){case zt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case zt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case zt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case zt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=zt.NONE}}function UA(n){this.enabled!==!1&&n.preventDefault()}function OA(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function BA(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var kA=.7,VA=2,Hx=n=>[n.x,n.y,n.z],bh=class{constructor(e,t,i){this.root=e;this.shared=t;this.still=i;this.renderer=new lh({antialias:!0,preserveDrawingBuffer:!0}),this.renderer.setPixelRatio(Math.min(VA,window.devicePixelRatio)),e.prepend(this.renderer.domElement),this.camera.up.set(0,0,1),this.controls=new yh(this.camera,this.renderer.domElement),this.controls.zoomToCursor=!0,this.controls.zoomSpeed=1.6,this.controls.addEventListener("change",()=>this.invalidate()),this.controls.addEventListener("start",()=>this.flight=null),this.observer=new ResizeObserver(()=>this.resize()),this.observer.observe(e),this.resize()}root;shared;still;scene=new Ga;camera=new Gn(35,1,.1,1e3);renderer;controls;clip=new Vt;onFrame=()=>!1;spent={update:0,render:0};flight=null;request=0;last=0;radius=100;observer;get width(){return Math.max(1,this.root.clientWidth)}get height(){return Math.max(1,this.root.clientHeight)}get aspect(){return this.width/this.height}get pose(){return{position:Hx(this.camera.position),target:Hx(this.controls.target),fov:this.camera.fov}}get distance(){return this.camera.position.distanceTo(this.controls.target)}resize(){this.renderer.setSize(this.width,this.height,!1),this.camera.aspect=this.aspect,this.invalidate()}reach(e){this.radius=e}go(e,t=!1){t||this.still?(this.flight=null,this.stand(e)):this.flight={from:this.pose,to:e,part:0},this.invalidate()}get goal(){return this.flight?.to??this.pose}zoom(e){let t=this.goal;this.go(bo(t,t.target,xi(Ft(t.position,t.target))*e))}orbit(e,t){let{position:i,target:s,fov:r}=this.goal,o=new z(...Ft(i,s)),a=Math.hypot(o.x,o.y),l=Math.atan2(o.z,a)+t*Math.PI/180,c=Math.atan2(o.y,o.x)+e*Math.PI/180,u=o.length(),d=Math.min(1.569,Math.max(-1.569,l)),h=u*Math.cos(d),f=[h*Math.cos(c),h*Math.sin(c),u*Math.sin(d)];this.go({position:[s[0]+f[0],s[1]+f[1],s[2]+f[2]],target:s,fov:r},!0)}shift(e){if(this.camera.position.add(new z(...e)),this.controls.target.add(new z(...e)),this.flight)for(let t of[this.flight.from,this.flight.to])for(let i of[t.position,t.target])i.forEach((s,r)=>i[r]=s+e[r])}stand(e){this.camera.position.set(...e.position),this.controls.target.set(...e.target),this.camera.fov=e.fov,this.controls.update()}invalidate(){this.request||=requestAnimationFrame(e=>this.frame(e))}frame(e){this.request=0;let t=this.last>0?(e-this.last)/1e3:0;if(this.flight){this.flight.part=Math.min(1,this.flight.part+Math.min(t,.1)/kA);let{from:o,to:a,part:l}=this.flight;this.stand(m0(o,a,l)),l>=1&&(this.flight=null)}let i=performance.now();this.fit();let s=this.onFrame(t)||this.flight!==null,r=performance.now();this.renderer.render(this.scene,this.camera),this.spent={update:r-i,render:performance.now()-r},this.last=s?e:0,s&&this.invalidate()}fit(){let e=this.camera,t=e.position.length()+1.5*this.radius+10;e.near=Math.max(.02*this.distance,t*2e-5,.01),e.far=t,e.updateProjectionMatrix(),e.updateMatrixWorld(),this.clip.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this.shared.pixel.value=2*Math.tan(e.fov*Math.PI/360)/this.height}dispose(){cancelAnimationFrame(this.request),this.observer.disconnect(),this.controls.dispose(),this.renderer.dispose(),this.renderer.forceContextLoss(),this.renderer.domElement.remove()}};var zA=5,GA=100,HA=55,WA=[1,2,5,10,20,50,100,200,500],XA=.5,qA=9,YA=12,Mh=class{constructor(e,t,i){this.model=t;this.stage=new bh(e,this.shared,i),e.append(this.labels.root);let{run:s,path:r,extent:o}=t,a=this.wide=o.reduce((h,f)=>Math.max(h,xi(f)),10),l=tp(o);this.ground=new gh(l,6*a),this.equipment=new mh(t,this.shared,l+.001),this.chain=t.chain?new dh(t.chain,this.shared):null;let c=s.geometry?.rollers??[];this.rollers=c.length>0?new xh(c,t,this.shared):null;let u=s.geometry?.reel;u&&(this.shared.reel.value.set(...t.at(u.center_m),u.radius_m),this.shared.reelAxis.value.set(...Rd(u.axis)));let{scene:d}=this.stage;d.add(this.ground.mesh,this.equipment.group),this.rollers&&d.add(this.rollers.mesh),this.chain&&(this.chain.mesh.visible=!1,d.add(this.chain.mesh)),this.stage.reach(6*a),this.routePoints=Float32Array.from((r?.points??[]).flat()),this.routeScreen=Xr(r?.points.length??0),this.rollerScreen=Xr(c.length)}model;stage;labels=new _h;chain;rollers;ground;shared=Sx();equipment;routePoints;routeScreen;rollerScreen;wide;unit=1;asked=null;get factor(){return this.shared.factor.value}exaggerate(e){this.asked=e,this.stage.invalidate()}paint(e){let t=Bx[e];this.stage.renderer.setClearColor(t.ground),this.equipment.recolour(t),this.rollers?.recolour(t.steel),this.ground.recolour(t.grid),this.shared.light.value.set(e==="dark"?.6:.68,.42),this.stage.invalidate()}scale(e){this.chain?.scale(e),this.stage.invalidate()}update(e){let{stage:t}=this,i=this.shared.pixel.value*t.distance,s=Math.min(GA,Math.max(1,zA*i/this.model.diameter));this.shared.factor.value=this.asked??s;let{target:r}=t.controls;this.ground.follow(r.x,r.y,t.distance,this.unit),this.ground.mesh.position.z=this.groundHeight(),this.equipment.shadow(t.distance>XA*this.wide),this.chain?.marks(WA.find(o=>o/i>HA)??1e3),e&&this.chain&&(this.chain.update(e.centres,e.values),this.chain.mesh.visible=!0)}groundHeight(){let{target:e}=this.stage.controls,t=2*this.stage.distance,i=this.model.extent.filter(([s,r])=>Math.hypot(s-e.x,r-e.y)<t);return tp(i.length>0?i:this.model.extent)}updateLabels(){this.labels.update(this.stage.clip,this.stage.width,this.stage.height)}rollerAt(e,t){let i=this.rollers;if(!i)return-1;let{stage:s,factor:r}=this;i.place(r),jo(i.centres,s.clip.elements,s.width,s.height,this.rollerScreen);let o=this.shared.pixel.value,a=i.drawnRadius(0,r);return Dx(this.rollerScreen,e,t,l=>Math.max(qA,a/(o*l)))}placeAt(e,t){let{stage:i,model:s}=this;if(!s.path)return null;jo(this.routePoints,i.clip.elements,i.width,i.height,this.routeScreen);let r=.5*s.diameter*this.factor/(this.shared.pixel.value*i.distance),o=Fx(this.routeScreen,e,t,Math.max(YA,1.2*r));if(!o)return null;let a=Math.min(s.path.points.length-2,Math.floor(o.index)),{s:l}=s.path;return l[a]+(o.index-a)*(l[a+1]-l[a])}onScreen(e){let t=Xr(1);return jo(e,this.stage.clip.elements,this.stage.width,this.stage.height,t),{x:t.x[0],y:t.y[0]}}dispose(){this.chain?.dispose(),this.rollers?.dispose(),this.equipment.dispose(),this.ground.dispose(),this.labels.root.remove(),this.stage.dispose()}};var $A="This browser does not draw in three dimensions here (no WebGL). Times and figures below still work, and everything is in the figures of this page.",ZA="These results hold no states (results.h5), so nothing moves.";function KA(){let n=y0.flatMap(([t,i])=>[I("span",{},I("kbd",{},t),` ${i}`)," "]);return I("details",{class:"view-help"},I("summary",{},"Space plays, \u2190 \u2192 step, + \u2212 zoom, 1\u20139 move the camera, F follows the head; all keys and the mouse"),I("p",{},"Drag turns, the right button moves, the wheel zooms once the picture has been clicked. A click on a roller or the cable shows its figures over time, a double click goes there."),I("p",{},...n))}function JA(n,e){let t=window.matchMedia("(prefers-reduced-motion: reduce)").matches;try{return new Mh(n,e.model,t)}catch(i){return console.info(i),n.classList.add("view-stage-empty"),n.prepend(I("p",{class:"view-notice",role:"note"},$A)),null}}function jA(n,e,t){let i=n.stage.renderer.domElement,s=-1,r=o=>{if(o===s)return;s=o;let a=t.get("roller")??-1;n.rollers?.mark(a,o),e.hover(o)};return A0(i,{hover:(o,a)=>{let l=n.rollerAt(o,a);r(l);let c=l>=0?e.model.run.geometry?.rollers[l]?.s_m??null:n.placeAt(o,a);i.style.cursor=l>=0||c!==null?"pointer":"",t.set("place",c)},leave:()=>{r(-1),t.set("place",null)},click:(o,a)=>{i.focus({preventScroll:!0});let l=n.rollerAt(o,a),c=n.placeAt(o,a);e.inspect(l>=0?{roller:l}:c!==null?{place:c}:null)},double:(o,a)=>{e.toPlace(n.placeAt(o,a))}})}function Wx(n,e,t){let i=I("p"),s=I("p",{class:"view-spoken","aria-live":"polite"}),r=new pc(e,t,new rc(i,s)),o=I("div",{class:"view-stage"}),a=I("div",{class:"view3d",role:"group","aria-label":"The pull in three dimensions"},r.tools.root,o,r.player.root,I("div",{class:"view-words"},i,s,KA()));n.replaceChildren(a);let l=[],c=JA(o,r);if(c){r.draws(c,new nc(c,()=>r.now,()=>r.playback.time)),o.append(r.legend.root,r.inspector.root);let h=c.stage.renderer.domElement;h.tabIndex=0,h.setAttribute("role","img"),h.setAttribute("aria-label","Route, rollers and cable; keys and a sentence on what is to be seen are below"),c.stage.controls.enableZoom=!1,h.addEventListener("focus",()=>c.stage.controls.enableZoom=!0),h.addEventListener("blur",()=>c.stage.controls.enableZoom=!1),l.push(jA(c,r,t))}let u=()=>{a.dataset.theme=t.get("theme"),r.redress()};return l.push(b0(a,r),t.subscribe("units",u),t.subscribe("theme",u),t.subscribe("place",()=>r.mark()),t.subscribe("time",(h,f)=>{f!==r&&h!==null&&r.showAt(h)}),t.subscribe("roller",(h,f)=>{f!==r&&r.inspect(h===null?null:{roller:h})})),u(),r.preset(0,!0),{ready:QA(e,r,i),viewer:r,dispose:()=>{l.forEach(h=>h()),r.dispose(),n.replaceChildren()}}}async function QA(n,e,t){if(!n.states||n.states.frames===0){t.textContent=ZA;return}t.textContent="Unpacking the states\u2026";try{await c0(n.states,(i,s)=>e.arrived(i,s)),e.forces=await S0(n),e.inspectAgain()}catch(i){t.textContent=`The states cannot be shown: ${i instanceof Error?i.message:String(i)}.`}}var eC=[r0,Bg,Mg,zg,Ng,Dg],tC=[Fg,t0,i0,Xg,qg,Yg,$g,jg,Qg,e0],Sh=class{constructor(e,t,i){this.data=t;this.store=i;this.viewSection=I("section",{id:"view","aria-labelledby":"view-heading"},I("h2",{id:"view-heading"},"The pull in three dimensions"),this.viewRoot);let s=I("div",{class:"body"},this.before,this.viewSection,this.after);e.replaceChildren(a0(t,i),this.heading,I("div",{class:"columns"},this.contents,s));for(let r of["units","theme"])i.subscribe(r,()=>this.fill());i.subscribe("run",()=>{this.memory.clear(),this.fill(),this.mount()}),addEventListener("beforeprint",()=>this.print(!0)),addEventListener("afterprint",()=>this.print(!1)),this.fill(),requestAnimationFrame(()=>setTimeout(()=>this.mount()))}data;store;figures=[];ends=[];memory=new Map;heading=I("header",{class:"page-head"});before=I("div");after=I("div");viewRoot=I("div",{class:"view"});viewSection;contents=I("nav",{class:"contents","aria-label":"Contents"});view=null;run(){let e=this.data.runs[this.store.get("run")]??this.data.runs[0];if(!e)throw new Error("The data of this page hold no run.");return e}context(){return{data:this.data,run:this.run(),store:this.store,units:this.store.get("units"),figure:e=>{let t=this.memory.get(e.id)??{zoom:null,hidden:new Set,open:!1};this.memory.set(e.id,t);let i=new Vl(e,this.store,t);return this.figures.push(i),i.element},onDispose:e=>this.ends.push(e)}}fill(){for(let o of this.figures)o.dispose();for(let o of this.ends)o();this.figures=[],this.ends=[];let e=this.context(),{run:t}=e,i=[this.before,this.after].map(o=>[o,o.offsetHeight]);for(let[o,a]of i)o.style.minHeight=`${a}px`;let s=o=>o.map(a=>a(e)).filter(a=>a!==null);this.before.replaceChildren(...s(eC)),this.after.replaceChildren(...s(tC)),requestAnimationFrame(()=>i.forEach(([o])=>o.style.minHeight=""));let r=t.summary.version?`simulated with hawser ${t.summary.version}`:"";this.heading.replaceChildren(I("p",{class:"kind"},"Report of a cable pull"),I("h1",{},mt(gd(t))),I("p",{class:"by"},mt(t.summary.case??t.label),r?` \xB7 ${r}`:""),...(t.notes??[]).map(o=>I("p",{class:"note"},mt(o)))),document.title=`${gd(t).slice(0,120)} \xB7 hawser`,this.list()}list(){let t=[...document.querySelectorAll("main section[id]")].map(i=>{let s=i.id==="verdict"?"Verdict":i.querySelector("h2")?.textContent??"";return I("li",{},I("a",{href:`#${i.id}`},s))});this.contents.replaceChildren(I("ul",{},...t))}mount(){this.view?.dispose(),this.view=null;let e=this.run();if(!e.states&&!e.geometry){this.viewRoot.replaceChildren(pn("These results hold neither states of the cable nor the geometry of the route, so there is nothing to play."));return}try{this.view=Wx(this.viewRoot,e,this.store)}catch(t){let i=t instanceof Error?t.message:String(t);this.viewRoot.replaceChildren(pn(`The view could not be made here: ${i}`))}}print(e){for(let t of this.figures)t.print(e);for(let t of document.querySelectorAll("details.long"))e&&(t.open=!0)}};var wh=class{constructor(e){this.state=e}state;listeners=new Map;get(e){return this.state[e]}set(e,t,i=null){if(Object.is(this.state[e],t))return;this.state[e]=t;let s=this.listeners.get(e);for(let r of[...s??[]])r(t,i)}subscribe(e,t){let i=this.listeners.get(e)??new Set;return i.add(t),this.listeners.set(e,i),()=>{i.delete(t)}}};function nC(n){let e=matchMedia("(prefers-color-scheme: dark)"),t=e.matches?"dark":"light",i=new wh({place:null,time:null,units:"si",theme:t,run:0,roller:null}),s=()=>{document.documentElement.dataset.theme=i.get("theme")};s(),i.subscribe("theme",s),e.addEventListener("change",()=>i.set("theme",e.matches?"dark":"light")),new Sh(n,wp(document),i)}var sp=document.getElementById("hawser");if(sp)try{nC(sp)}catch(n){throw sp.replaceChildren(I("p",{class:"failed",role:"alert"},n instanceof Error?n.message:String(n))),n}})();
